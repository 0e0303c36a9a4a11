// A motion over time as ECharts draws it: panels one below the other, over one axis of time.
import { axis, kCommon } from './echarts_parts.js';
import { axisName } from './format.js';
import { motionInks, stopAreas } from './orbit_charts.js';

const kHeights = { displacement: 170, velocity: 150, curves: 130 }, kBetween = 14, kTop = 12, kBottom = 50;  // px
const kMostMarks = 3000, kMostJumps = 200;  // beyond, jumps would fill the panel

// How high all panels are together.
export function runHeight(view) {
  return view.panels.reduce((sum, panel) => sum + kHeights[panel.kind] + kBetween, kTop + kBottom - kBetween);
}

function grids(view, height) {
  const room = Math.max(0, height - runHeight(view)) / view.panels.length;
  let top = kTop;
  return view.panels.map((panel) => {
    // Panels stay in line, however wide the numbers of one are.
    const grid = { left: 100, right: 22, top, height: kHeights[panel.kind] + room, outerBoundsMode: 'none' };
    top += grid.height + kBetween;
    return grid;
  });
}

function points(view, panel, t, y) {
  return Array.from(t, (time, i) => [view.time.factor * time, panel.factor * y[i]]);
}

// Of the impacts of a place those within [low, high] s, at most `most`, evenly.
export function impactsWithin({ t }, [low, high], most = Infinity) {
  const found = [];
  for (let i = 0; i < t.length; ++i) if (t[i] >= low && t[i] <= high) found.push(i);
  const stride = Math.ceil(found.length / most);
  return stride > 1 ? found.filter((_, k) => k % stride === 0) : found;
}

// Whether there are too many impacts to show all of them at once.
export function marksDependOnView(view) {
  return view.places.some((place) => place.impacts.t.length > kMostJumps);
}

// Impacts and the jumps of the velocity at them, by the ids of their series.
export function runMarks(view, shows, window) {
  return view.panels.flatMap((panel, i) => {
    if (panel.kind === 'curves') return [];
    const { impacts } = view.places[panel.place];
    const at = (k, y) => [view.time.factor * impacts.t[k], panel.factor * y[k]];
    if (panel.kind === 'displacement') {
      const shown = shows('impacts') ? impactsWithin(impacts, window, kMostMarks) : [];
      return [{ id: `impacts ${i}`, symbolSize: shown.length > 60 ? 4 : 7, data: shown.map((k) => at(k, impacts.place)) }];
    }
    const jumps = shows('impacts') ? impactsWithin(impacts, window) : [];
    return [{
      id: `jumps ${i}`,
      data: jumps.length > kMostJumps ? [] : jumps.flatMap((k) => [at(k, impacts.before), at(k, impacts.after), [NaN, NaN]]),
    }];
  });
}

function zeroLine(panel, colours) {
  return panel.low < 0 && panel.high > 0 ? {
    symbol: 'none', silent: true, label: { show: false }, lineStyle: { color: colours.faint, type: 'solid', width: 0.8 }, data: [{ yAxis: 0 }],
  } : undefined;
}

function motionSeries(view, panel, i, shows, inks) {
  const place = view.places[panel.place];
  const moves = panel.kind === 'displacement';
  const range = [panel.factor * panel.low, panel.factor * panel.high];
  const stuck = !shows('stuck') ? [] : place.stuck.map(([from, to]) => [
    { xAxis: view.time.factor * from, yAxis: range[0], itemStyle: { color: inks.stuck, opacity: 0.8 } },
    { xAxis: view.time.factor * to, yAxis: range[1] }]);
  const stops = moves ? stopAreas(place.stops.map((stop) => ({ ...stop, place: panel.factor * stop.place })), range, 'yAxis', inks.stop) : [];
  const marks = moves
    ? { id: `impacts ${i}`, type: 'scatter', itemStyle: { color: inks.impact, opacity: 1 } }
    : { id: `jumps ${i}`, type: 'line', showSymbol: false, lineStyle: { color: inks.impact, width: 1, type: [4, 3] } };
  const common = { xAxisIndex: i, yAxisIndex: i, silent: true, animation: false };
  return [{
    ...common, id: `motion ${i}`, type: 'line', showSymbol: false, z: 4, lineStyle: { color: inks.motion, width: 1.5 },
    data: points(view, panel, place.t, moves ? place.x : place.v),
    markArea: { silent: true, data: [...stuck, ...stops] }, markLine: moves ? undefined : zeroLine(panel, inks.colours),
  }, { ...common, z: 6, data: [], ...marks }];
}

function curveSeries(view, panel, i, shows, theme) {
  return panel.curves.map((curve, k) => ({
    id: `curve ${i} ${k}`, type: 'line', showSymbol: false, silent: true, animation: false, xAxisIndex: i, yAxisIndex: i, z: 4,
    // The first one is seen under another that it coincides with.
    lineStyle: { color: theme.shade(curve.colour), width: k === 0 ? 2 : 1.3 },
    data: shows(`${i} ${k}`) ? points(view, panel, curve.t, curve.y) : [],
    markLine: k === 0 ? zeroLine(panel, theme.colours) : undefined,
  }));
}

export function runOption(view, shows, theme, height) {
  const { time, panels } = view;
  const { colours } = theme;
  const inks = motionInks(view, theme);
  const last = panels.length - 1;
  return {
    ...kCommon, grid: grids(view, height),
    xAxis: panels.map((_, i) => ({
      ...axis(colours, i === last ? axisName(time) : '', time.factor * time.low, time.factor * time.high, { gridIndex: i, nameGap: 28 }),
      ...(i === last ? {} : { axisLabel: { show: false } }),
    })),
    yAxis: panels.map((panel, i) => axis(colours, `${panel.name}\n${panel.more ? `${panel.more} ` : ''}${panel.unit ? `(${panel.unit})` : ''}`,
      panel.factor * panel.low, panel.factor * panel.high,
      { gridIndex: i, nameGap: 56, splitNumber: 3, nameTextStyle: { color: colours.ink, fontSize: 12, lineHeight: 14 } })),
    series: panels.flatMap((panel, i) => (panel.kind === 'curves'
      ? curveSeries(view, panel, i, shows, theme) : motionSeries(view, panel, i, shows, inks))),
    dataZoom: [{ id: 'across', type: 'inside', xAxisIndex: panels.map((_, i) => i), filterMode: 'none', minSpan: 1e-5 }],
  };
}
