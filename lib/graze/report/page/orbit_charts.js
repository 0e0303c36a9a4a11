// The three pictures of an orbit: its displacement over time against the stops, its phase portrait,
// its multipliers in the unit circle.
import { axis, kCommon } from './echarts_parts.js';
import { axisName } from './format.js';

// The colours of a motion on this ground: { motion, impact, stop, stuck, colours }.
export function motionInks({ looks }, theme) {
  const inks = Object.fromEntries(['motion', 'impact', 'stop', 'stuck'].map((name) => [name, theme.shade(looks[name])]));
  return { ...inks, colours: theme.colours };
}

// A curve as pieces between jumps, each a list of indices; it is cut where a sample is not finite.
export function pieces(place) {
  const list = [[]];
  for (let i = 0; i < place.t.length; ++i)
    if (Number.isFinite(place.t[i])) list.at(-1).push(i);
    else if (list.at(-1).length > 0) list.push([]);
  return list.filter((piece) => piece.length > 0);
}

// Over [0, p) forcing periods: what lies beyond is drawn at the start again.
function wrapped(orbit, place) {
  const data = [];
  const begin = Math.min(...orbit.span ?? [0]);
  const periods = orbit.period;
  for (const piece of pieces(place)) {
    let turn = null;
    for (const i of piece) {
      const now = periods ? Math.floor((place.t[i] - begin) / periods - 1e-7) : 0;
      if (turn !== null && now !== turn) data.push([NaN, NaN]);
      turn = now;
      data.push([place.t[i] - (periods ? now * periods : 0), place.x[i]]);
    }
    data.push([NaN, NaN]);
  }
  return data;
}

function extent(values, ...more) {
  let low = Infinity, high = -Infinity;
  const include = (value) => {
    if (!Number.isFinite(value)) return;
    low = Math.min(low, value);
    high = Math.max(high, value);
  };
  for (const value of values) include(value);
  for (const value of more) include(value);
  if (!(low <= high)) return [0, 1];
  const room = 0.07 * (high - low) || Math.abs(high) || 1;
  return [low - room, high + room];
}

// Which way what is shown of a place counts: " towards stop 2", or nothing where there is no stop.
function towards({ stops, name }) {
  if (stops.length === 0) return '';
  return ` towards ${stops.length > 1 ? `stop ${stops[0].index}` : name}`;
}

// `axes`: name, unit and factor of both, where they are not a length and a speed.
function scaled(place, axes) {
  // In two lines, as the pictures are small.
  const named = (quantity) => ({ ...quantity, name: `${quantity.name}\n${towards(place).trim()}`.trim() });
  const length = named(axes?.length ?? { name: 'displacement', ...place.length });
  const speed = named(axes?.speed ?? { name: 'velocity', ...place.speed });
  return {
    length, speed,
    place: {
      ...place, x: place.x.map((x) => length.factor * x), v: place.v.map((v) => speed.factor * v),
      stops: place.stops.map((stop) => ({ ...stop, place: length.factor * stop.place })),
    },
  };
}

function twoLines(colours) { return { nameTextStyle: { color: colours.ink, fontSize: 12, lineHeight: 14 } }; }

// The inside of the stops, as areas of a colour between a stop and the border of the axes.
export function stopAreas(stops, [low, high], name, ground) {
  return stops.map((stop) => [
    { [name]: stop.place, itemStyle: { color: ground, opacity: 0.75 } },
    { [name]: stop.sense > 0 ? high : low },
  ]);
}

export function seriesOption(orbit, seen, inks) {
  const { colours } = inks;
  const { place, length } = scaled(seen);
  const y = extent(place.x, ...place.stops.map((stop) => stop.place));
  const x = orbit.span ?? [0, orbit.period];
  const stuck = orbit.stuck.filter((phase) => place.stops.some((stop) => stop.index === phase.stop))
    .flatMap(({ from, to }) => (orbit.period && to > orbit.period
      ? [[from, orbit.period], [0, to - orbit.period]] : [[from, to]]))
    .map(([from, to]) => [{ xAxis: from, yAxis: y[0], itemStyle: { color: inks.stuck, opacity: 0.8 } }, { xAxis: to, yAxis: y[1] }]);
  const impacts = orbit.impacts.flatMap((impact) => {
    const stop = place.stops.find(({ index }) => index === impact.stop);
    return stop ? [[impact.t, stop.place]] : [];
  });
  return {
    ...kCommon, grid: { left: 74, right: 14, top: 10, bottom: 42, outerBoundsMode: 'none' },
    xAxis: axis(colours, 'time (forcing periods)', x[0], x[1], { nameGap: 26 }),
    yAxis: axis(colours, axisName(length), y[0], y[1], { nameGap: 40, splitNumber: 4, ...twoLines(colours) }),
    series: [
      {
        id: 'motion', type: 'line', data: wrapped(orbit, place), showSymbol: false, silent: true, z: 4,
        lineStyle: { color: inks.motion, width: 1.8 },
        markArea: { silent: true, data: [...stuck, ...stopAreas(place.stops, y, 'yAxis', inks.stop)] },
      },
      {
        id: 'impacts', type: 'scatter', data: impacts, silent: true, z: 6, symbolSize: impacts.length > 60 ? 4 : 7,
        itemStyle: { color: inks.impact, opacity: 1 },
      },
    ],
  };
}

// The jumps of the velocity at impacts, each from one point of the phase plane to another.
function jumpsOf(orbit, place) {
  const jumps = [];
  const list = pieces(place);
  list.forEach((piece, k) => {
    const end = piece.at(-1), next = list[k + 1]?.[0] ?? (orbit.period ? list[0][0] : null);
    if (next === null || place.v[end] === place.v[next]) return;
    jumps.push([[place.x[end], place.v[end]], [place.x[next], place.v[next]]]);
  });
  return jumps;
}

export function portraitOption(orbit, seen, inks, axes = null) {
  const { colours } = inks;
  const { place, length, speed } = scaled(seen, axes);
  const x = extent(place.x, ...place.stops.map((stop) => stop.place));
  const y = extent(place.v, 0);
  const flights = pieces(place).flatMap((piece) => [...piece.map((i) => [place.x[i], place.v[i]]), [NaN, NaN]]);
  const jumps = jumpsOf(orbit, place).flatMap(([from, to]) => [from, to, [NaN, NaN]]);
  const line = (id, data, style) => ({ id, type: 'line', data, showSymbol: false, silent: true, lineStyle: style });
  return {
    ...kCommon, grid: { left: 78, right: 10, top: 10, bottom: 56, outerBoundsMode: 'none' },
    xAxis: axis(colours, axisName(length), x[0], x[1], { nameGap: 24, splitNumber: 3, ...twoLines(colours) }),
    yAxis: axis(colours, axisName(speed), y[0], y[1], { nameGap: 38, splitNumber: 4, ...twoLines(colours) }),
    series: [
      { ...line('flights', flights, { color: inks.motion, width: 1.6 }), z: 4,
        markArea: { silent: true, data: stopAreas(place.stops, x, 'xAxis', inks.stop) } },
      { ...line('jumps', jumps, { color: inks.impact, width: 1.2, type: [4, 3] }), z: 5 },
    ],
  };
}

const kFarOut = 4;  // modulus

export function circleOption(orbit, inks, size) {
  const { colours } = inks;
  const turn = Array.from({ length: 181 }, (_, k) => [Math.cos((k * Math.PI) / 90), Math.sin((k * Math.PI) / 90)]);
  const modulus = ([re, im]) => Math.hypot(re, im);
  const inside = orbit.multipliers.filter((multiplier) => modulus(multiplier) <= 1);
  const near = orbit.multipliers.filter((multiplier) => modulus(multiplier) > 1 && modulus(multiplier) <= kFarOut);
  // The circle has to be seen beside them: those far out stand at the border, in their direction.
  const reach = 1.15 * Math.min(kFarOut, Math.max(1, ...orbit.multipliers.map(modulus)));
  const far = orbit.multipliers.filter((multiplier) => modulus(multiplier) > kFarOut)
    .map(([re, im]) => [re, im].map((part) => (kFarOut * part) / Math.hypot(re, im)));
  // One unit is as long upright as across.
  const left = 50, right = 10, top = 10, bottom = 42;
  const proportion = Math.max(0.2, (size.height - top - bottom) / (size.width - left - right));
  const x = proportion < 1 ? reach / proportion : reach, y = proportion < 1 ? reach : reach * proportion;
  const points = (id, data, colour, symbol = 'circle') => ({
    id, type: 'scatter', data, silent: true, symbol, symbolSize: 8, z: 5, itemStyle: { color: colour, opacity: 1 },
  });
  return {
    ...kCommon, grid: { left, right, top, bottom },
    xAxis: axis(colours, 'Re multiplier', -x, x, { nameGap: 26, splitNumber: 3 }),
    yAxis: axis(colours, 'Im multiplier', -y, y, { nameGap: 34, splitNumber: 4 }),
    series: [
      { id: 'circle', type: 'line', data: turn, showSymbol: false, silent: true, lineStyle: { color: colours.faint, width: 1.2 } },
      points('inside', inside, inks.motion), points('outside', near, inks.impact),
      points('far', far, inks.impact, 'diamond'),
    ],
  };
}
