// What the points of a chart are of, as the program leaves it (ChartThings): what each is called, the
// numbers that it has, and which orbit of the page shows it.

const kDigits = 15, kRoughDigits = 8;  // of what the program leaves in double, in single precision

export class Things {
  constructor({ kinds, kind, numbers, more, kept = [] }) {
    Object.assign(this, { kinds, kind, more, kept });
    this.numbers = numbers.map(({ rough, exact, ...number }) => ({ ...number, values: joined(rough, exact), rough: rough.length }));
  }

  get axes() { return this.numbers.filter(({ axis }) => axis); }
  // What all things are over: a parameter.
  get parameter() { return this.numbers.find(({ given }) => given); }
  number(key) { return this.numbers.find((number) => number.key === key); }

  kindOf(thing) { return this.kinds[this.kind[thing]]; }

  indexOf(number, thing, which) {
    if (!(thing >= 0)) return -1;
    if (number.single) return thing;
    const at = number.first[thing] + which;
    return at < number.first[thing + 1] ? at : -1;
  }

  // SI; NaN where there is none.
  valueOf(number, thing, which = 0) { return number.values[this.indexOf(number, thing, which)] ?? NaN; }
  digitsOf(number, thing, which = 0) { return this.indexOf(number, thing, which) < number.rough ? kRoughDigits : kDigits; }

  // Which orbit of the page is of a thing or of the nearest like it; -1 where none is kept.
  orbitOf(thing, distance = (a, b) => Math.abs(a - b)) {
    const kind = this.kindOf(thing);
    let best = -1, least = Infinity;
    this.kept.forEach((at, orbit) => {
      if (this.kindOf(at)?.of !== kind?.of) return;
      const away = distance(at, thing);
      if (away < least) [least, best] = [away, orbit];
    });
    return best;
  }
}

// One list of both; a million cells are not copied.
function joined(rough, exact) {
  if (exact.length === 0) return rough;
  const values = new Float64Array(rough.length + exact.length);
  values.set(rough);
  values.set(exact, rough.length);
  return values;
}

// The things of points that come in runs, and which of each thing's values they are.
function spread({ thing, count }) {
  const total = count.reduce((sum, more) => sum + more, 0);
  const of = new Int32Array(total), which = new Int32Array(total);
  let at = 0;
  thing.forEach((one, run) => { for (let k = 0; k < count[run]; ++k, ++at) [of[at], which[at]] = [one, k]; });
  return { of, which };
}

// The series of a panel with its points as numbers along the axes, and 1 in `ends` where a line ends: an
// angle passes its whole turn there.
export function placed(series, scales, things) {
  const { of, which } = series.runs ? (series.spread ??= spread(series.runs)) : series;
  const count = (series.x ?? of).length;
  const given = { x: series.x, y: series.y };
  const [x, y] = ['x', 'y'].map((name) => {
    const scale = scales[name], number = scale.quantity;
    if (given[name]) return Float64Array.from(given[name], (value) => scale.of(value));
    return Float64Array.from({ length: count }, (_, i) => scale.of(things.valueOf(number, of[i], which[i])));
  });
  const turning = series.x || !series.line ? [] : [scales.x, scales.y].map(({ quantity }) => quantity).filter(({ turn }) => turn);
  const at = (number, i) => things.valueOf(number, of[i], which[i]);
  const ends = turning.length === 0 ? undefined : Uint8Array.from({ length: count },
    (_, i) => (turning.some((number) => Math.abs(at(number, i + 1) - at(number, i)) > number.turn / 2) ? 1 : 0));
  return { series, x, y, of, which, ends, drawn: x.some((value, i) => Number.isFinite(value) && Number.isFinite(y[i])) };
}
