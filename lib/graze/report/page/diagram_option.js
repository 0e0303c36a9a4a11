// A diagram as ECharts draws it: axes, lines of branches, marks of special points. The dots of the
// sweep lie under it (dot_layer.js).
import { axis, hertzAxis, kCommon } from './echarts_parts.js';
import { axisName } from './format.js';
import { pen, specialLook, stamp } from './marks.js';
import { branchNames } from './branch_names.js';
import { nearAxes } from './near_axes.js';

const kStrip = 120, kBetween = 26;  // height of a panel below the picture, and what is above it, px

// The grids one below the other: the picture, then the strips.
function grids(strips, hertz, height) {
  const top = hertz ? 52 : 16, bottom = 52, left = 76, right = 22;
  const below = strips.length * (kStrip + kBetween);
  const main = { left, right, top, height: Math.max(120, height - top - bottom - below) };
  return [main, ...strips.map((_, i) => ({
    left, right, height: kStrip, top: top + main.height + kBetween + i * (kStrip + kBetween),
  }))];
}

// All lines of a kind in one series, broken where one ends.
function lineSeries(picture, kind) {
  const { view, geometry, ranges, theme, shows } = picture;
  const look = view.looks.lines[kind];
  const data = [];
  if (shows(look.id))
    for (const line of geometry.lines)
      if (line.kind === kind) for (const point of nearAxes(line, ranges.x, ranges.y)) data.push(point);
  return {
    id: `line ${look.id}`, type: 'line', data, showSymbol: false, silent: true, animation: false, symbol: 'none', z: 3 + kind,
    lineStyle: pen(look, theme),
  };
}

function markSeries({ view, geometry, theme, shows, labels }, type) {
  const look = specialLook(view.looks, type);
  const marks = shows(type) ? geometry.marks.filter(({ special }) => special.type === type) : [];
  return {
    id: `mark ${type}`, type: 'scatter', silent: true, animation: false, z: 10, ...stamp(look, theme),
    data: marks.map(({ special, x, y }) => ({ value: [x, y], name: special.id })),
    label: markLabel(theme, labels), labelLayout: { hideOverlap: true },
  };
}

// The names of branches, each in the middle of what is in view of it.
function nameSeries({ view, geometry, theme, shows, labels }, inView) {
  const shown = geometry.lines.filter((line) => shows(view.looks.lines[line.kind].id));
  return {
    id: 'branch names', type: 'scatter', silent: true, animation: false, z: 9, symbolSize: 0,
    data: labels ? branchNames(view, shown, inView) : [], label: markLabel(theme, labels), labelLayout: { hideOverlap: true },
  };
}

// The name of a mark above it.
export function markLabel(theme, show) {
  return {
    show, formatter: '{b}', position: 'top', distance: 3, fontSize: 11, color: theme.colours.ink,
    textBorderColor: theme.colours.paper, textBorderWidth: 2.5,
  };
}

function referenceLine(theme, data) {
  return {
    symbol: 'none', silent: true, label: { show: false }, lineStyle: { color: theme.colours.faint, type: 'solid', width: 1 }, data,
  };
}

// Its largest values, over the others if those are shown.
function stripSeries({ view, geometry, theme, shows }, strip, i) {
  const dots = (id, { values, heights }, look, z) => ({
    id, type: 'scatter', xAxisIndex: i + 1, yAxisIndex: i + 1, clip: true, silent: true, animation: false,
    data: Array.from(values, (value, k) => [geometry.x.of(value), strip.factor * heights[k]]),
    symbolSize: strip.values.length > 2000 ? 2 : 3, z, itemStyle: { color: theme.shade(look.colour), opacity: 1 },
  });
  const { largest, lower } = view.looks.dots;
  const top = dots(`strip ${i}`, strip, largest, 4);
  if (strip.reference !== undefined) top.markLine = referenceLine(theme, [{ yAxis: strip.factor * strip.reference }]);
  return [dots(`strip ${i} lower`, shows(lower.id) ? strip.lower : { values: [], heights: [] }, lower, 3), top];
}

function references({ geometry, theme }) {
  const data = ['x', 'y'].flatMap((name) => {
    const at = geometry[name].of(geometry[name].quantity.reference);
    return Number.isFinite(at) ? [{ [`${name}Axis`]: at }] : [];
  });
  return data.length > 0 ? referenceLine(theme, data) : undefined;
}

// Panels below show the same parameter.
export function stripsOf(view, scale) { return scale.quantity === view.parameter ? view.strips : []; }

// `picture`: { view, geometry, ranges: { x, y }, theme, shows(type), labels }; `inView`: the part of
// the ranges that is in view.
export function diagramOption(picture, inView, height) {
  const { view, geometry, ranges, theme } = picture;
  const { colours } = theme;
  const strips = stripsOf(view, geometry.x);
  const hertz = view.parameter.hertz && geometry.x.quantity === view.parameter && geometry.x.kind === 'linear';
  const x = [0, ...strips].map((_, i) => {
    const last = i === strips.length;
    const made = axis(colours, last ? geometry.x.name : '', ...ranges.x, { gridIndex: i, nameGap: 30 });
    if (!last) made.axisLabel = { show: false };
    return made;
  });
  if (hertz) x.push(hertzAxis(colours, ...ranges.x));
  const y = [axis(colours, geometry.y.name, ...ranges.y, { gridIndex: 0, nameGap: 54 }),
    ...strips.map((strip, i) => axis(colours, axisName(strip), strip.factor * strip.low, strip.factor * strip.high,
      { gridIndex: i + 1, nameGap: 54, splitNumber: 3 }))];
  const types = [...new Set(view.special.map((special) => special.type))];
  const series = view.looks.lines.map((_, kind) => lineSeries(picture, kind));
  series[0].markLine = references(picture);
  series.push(nameSeries(picture, inView), ...types.map((type) => markSeries(picture, type)), ...strips.flatMap((strip, i) => stripSeries(picture, strip, i)));
  return {
    ...kCommon, grid: grids(strips, hertz, height), xAxis: x, yAxis: y, series,
    dataZoom: [
      { id: 'across', type: 'inside', xAxisIndex: x.map((_, i) => i), filterMode: 'none', minSpan: 1e-7 },
      { id: 'upright', type: 'inside', yAxisIndex: [0], filterMode: 'none', minSpan: 1e-7, zoomOnMouseWheel: 'shift' },
    ],
  };
}

// The names of branches anew, to be merged into an option.
export function diagramNames(picture, inView) { return { series: [nameSeries(picture, inView)] }; }

// The axes' tics for what is in view, to be merged into an option: logarithmic ones depend on it.
export function diagramTics(view, { x, y }, inView) {
  const strips = stripsOf(view, x);
  const across = x.tics(...inView.x);
  const silent = across.axisTick ? { axisTick: across.axisTick } : {};
  return {
    xAxis: [...strips.map(() => silent), across],
    yAxis: [y.tics(...inView.y)],
  };
}
