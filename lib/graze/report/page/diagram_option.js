// The picture over a parameter as ECharts draws it: axes, lines of branches, marks of special
// points. The dots of the sweep lie under it (dot_layer.js).
import { axis, hertzAxis, kCommon } from './echarts_parts.js';
import { axisName } from './format.js';
import { kLineKinds, kLowerKind, markOf } from './marks.js';

const kStrip = 120, kBetween = 26;  // height of a panel below the picture, and what is above it, px

// The grids one below the other: the picture, then the strips.
function grids(view, height) {
  const top = view.parameter.hertz ? 52 : 16, bottom = 52, left = 76, right = 22;
  const below = view.strips.length * (kStrip + kBetween);
  const main = { left, right, top, height: Math.max(120, height - top - bottom - below) };
  return [main, ...view.strips.map((_, i) => ({
    left, right, height: kStrip, top: top + main.height + kBetween + i * (kStrip + kBetween),
  }))];
}

function xAxes(view, colours) {
  const { parameter } = view;
  const low = parameter.factor * Math.min(parameter.from, parameter.to);
  const high = parameter.factor * Math.max(parameter.from, parameter.to);
  const axes = [0, ...view.strips].map((_, i) => {
    const last = i === view.strips.length;
    const made = axis(colours, last ? axisName(parameter) : '', low, high, { gridIndex: i, nameGap: 30 });
    if (!last) made.axisLabel = { show: false };
    return made;
  });
  if (parameter.hertz)
    axes.push(hertzAxis(colours, low, high));
  return axes;
}

function yAxes(view, shown, colours) {
  const of = (quantity, gridIndex) => axis(colours, axisName(quantity), quantity.factor * quantity.low,
    quantity.factor * quantity.high, { gridIndex, nameGap: 54 });
  return [of(shown, 0), ...view.strips.map((strip, i) => ({ ...of(strip, i + 1), splitNumber: 3 }))];
}

// A line as far as it runs near the axes: next to a grazing a multiplier has no bound, and along a
// path of a billion pixels no canvas draws dashes.
function nearAxes(line, shown) {
  const span = shown.high - shown.low;
  const low = shown.low - span, high = shown.high + span;
  const nodes = [];
  const inside = (i) => i >= 0 && i < line.y.length && line.y[i] >= low && line.y[i] <= high;
  const end = (i, outside) => {
    const y = line.y[outside] > high ? high : low;
    const part = (y - line.y[i]) / (line.y[outside] - line.y[i]);
    return [line.x[i] + part * (line.x[outside] - line.x[i]), y];
  };
  for (let i = 0; i < line.x.length; ++i) {
    if (!inside(i)) continue;
    if (i > 0 && !inside(i - 1)) nodes.push([NaN, NaN], end(i, i - 1));
    nodes.push([line.x[i], line.y[i]]);
    if (i + 1 < line.x.length && !inside(i + 1)) nodes.push(end(i, i + 1), [NaN, NaN]);
  }
  return nodes;
}

// All lines of a kind in one series, broken where one ends.
function lineSeries(view, shown, kind, shows, colours) {
  const style = kLineKinds[kind];
  const data = [];
  if (shows(style.type))
    for (const line of view.lines[shown.key] ?? []) {
      if (line.kind !== kind) continue;
      for (const [x, y] of nearAxes(line, shown)) data.push([view.parameter.factor * x, shown.factor * y]);
      data.push([NaN, NaN]);
    }
  return {
    id: `line ${style.type}`, type: 'line', data, showSymbol: false, silent: true, animation: false,
    symbol: 'none', z: 3 + kind,
    lineStyle: { color: colours[style.colour], width: style.width, type: style.dash },
  };
}

function markSeries(view, shown, type, shows, colours) {
  const mark = markOf(type);
  const data = [];
  if (shows(type))
    for (const special of view.special)
      if (special.type === type)
        for (const height of special.y[shown.key] ?? [])
          data.push([view.parameter.factor * special.value, shown.factor * height]);
  return {
    id: `mark ${type}`, type: 'scatter', data, silent: true, animation: false, z: 10,
    symbol: `path://${mark.path}`, symbolSize: mark.small ? 7 : 12,
    itemStyle: {
      color: mark.filled ? colours[mark.colour] : colours.paper, borderColor: colours[mark.colour],
      borderWidth: 1.8, opacity: 1,
    },
  };
}

// Its largest values, over the others if those are shown.
function stripSeries(view, strip, i, shows, colours) {
  const dots = (id, { values, heights }, colour, z) => {
    const data = Array.from(values, (value, k) => [view.parameter.factor * value, strip.factor * heights[k]]);
    return {
      id, type: 'scatter', xAxisIndex: i + 1, yAxisIndex: i + 1, data, clip: true, silent: true, animation: false,
      symbolSize: strip.values.length > 2000 ? 2 : 3, z, itemStyle: { color: colours[colour], opacity: 1 },
    };
  };
  const largest = dots(`strip ${i}`, strip, 'blue', 4);
  if (strip.reference !== undefined)
    largest.markLine = {
      symbol: 'none', silent: true, label: { show: false },
      lineStyle: { color: colours.faint, type: 'solid', width: 1 },
      data: [{ yAxis: strip.factor * strip.reference }],
    };
  const none = { values: [], heights: [] };
  return [dots(`strip ${i} lower`, shows(kLowerKind.type) ? strip.lower : none, kLowerKind.colour, 3), largest];
}

export function diagramOption(view, shown, shows, colours, height) {
  const x = xAxes(view, colours);
  const types = [...new Set(view.special.map((special) => special.type))];
  const series = kLineKinds.map((_, kind) => lineSeries(view, shown, kind, shows, colours));
  if (shown.reference !== undefined)
    series[0].markLine = {
      symbol: 'none', silent: true, label: { show: false },
      lineStyle: { color: colours.faint, type: 'solid', width: 1 },
      data: [{ yAxis: shown.factor * shown.reference }],
    };
  series.push(...types.map((type) => markSeries(view, shown, type, shows, colours)));
  series.push(...view.strips.flatMap((strip, i) => stripSeries(view, strip, i, shows, colours)));
  return {
    ...kCommon,
    grid: grids(view, height), xAxis: x, yAxis: yAxes(view, shown, colours), series,
    dataZoom: [
      { id: 'across', type: 'inside', xAxisIndex: x.map((_, i) => i), filterMode: 'none', minSpan: 1e-7 },
      { id: 'upright', type: 'inside', yAxisIndex: [0], filterMode: 'none', minSpan: 1e-7, zoomOnMouseWheel: 'shift' },
    ],
  };
}
