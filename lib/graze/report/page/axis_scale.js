// How SI values become numbers along an axis, and its tics: as they are, by their logarithm, or in
// decibels. Every axis of a chart is a linear one of those numbers.
import { axisName, measure } from './format.js';

export const kScales = { linear: 'linear', log: 'logarithmic', decibel: 'dB' };

const kMostTics = 9;

export class AxisScale {
  // `quantity`: { name, unit, si, factor, .. } as the program leaves it.
  constructor(quantity, kind = 'linear') {
    Object.assign(this, { quantity, kind });
  }

  // NaN where there is none: what is not positive has no logarithm, and decibels tell sizes.
  of(value) {
    if (this.kind === 'linear') return this.quantity.factor * value;
    if (this.kind === 'log') return value > 0 ? Math.log10(this.quantity.factor * value) : NaN;
    return value !== 0 ? 20 * Math.log10(Math.abs(value)) : NaN;
  }

  // SI; of decibels the size.
  back(number) {
    if (this.kind === 'linear') return number / this.quantity.factor;
    return this.kind === 'log' ? 10 ** number / this.quantity.factor : 10 ** (number / 20);
  }

  get name() {
    if (this.kind !== 'decibel') return axisName(this.quantity);
    return `${this.quantity.name} (dB${this.quantity.si ? ` re 1 ${this.quantity.si}` : ''})`;
  }

  measure(number, digits) { return measure(this.quantity, this.back(number), digits); }

  // What an ECharts axis is told beside its range: `low` and `high` are what is in view of it.
  tics(low, high) {
    if (this.kind !== 'log') return {};
    const values = logTics(low, high);
    return {
      axisTick: { customValues: values },
      axisLabel: { customValues: values, showMinLabel: true, showMaxLabel: true, formatter: (value) => power(value) },
    };
  }
}

function power(logarithm) {
  const value = 10 ** logarithm;
  const text = value < 1e-4 || value >= 1e6 ? value.toExponential(2).replace(/\.?0+e/, 'e').replace('e+', 'e')
    : String(Number(value.toPrecision(6)));
  return text.replace('-', '−');
}

// Logarithms of round numbers within [low, high]: powers of ten, then also 2 and 5 times these, then
// all digits, then numbers evenly spaced.
function logTics(low, high) {
  const decades = high - low;
  if (!(decades > 0)) return [low];
  if (decades < 0.5) return evenTics(10 ** low, 10 ** high).map(Math.log10);
  const stride = Math.max(1, Math.ceil(decades / kMostTics));
  const digits = decades > 4 ? [1] : decades > 1.3 ? [1, 2, 5] : [1, 2, 3, 4, 5, 6, 7, 8, 9];
  const list = [];
  for (let decade = Math.floor(low / stride) * stride; decade <= high; decade += stride)
    for (const digit of digits) {
      const at = decade + Math.log10(digit);
      if (at >= low && at <= high) list.push(at);
    }
  return list;
}

function evenTics(low, high) {
  const rough = (high - low) / 5;
  const base = 10 ** Math.floor(Math.log10(rough));
  const step = base * [1, 2, 5, 10].find((times) => times * base >= rough);
  const list = [];
  for (let i = Math.ceil(low / step); i * step <= high; ++i) list.push(i * step);
  return list;
}
