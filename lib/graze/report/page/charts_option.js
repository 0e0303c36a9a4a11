// A chart of the program (report/chart) as ECharts draws it: rows of panels with curves, marks, bars of
// error, fills, levels and words.
import { axis, hertzAxis, kCommon } from './echarts_parts.js';
import { lineNames } from './line_names.js';
import { pen, stamp } from './marks.js';
import { nearAxes } from './near_axes.js';

const kPixels = 58;  // of a centimetre of a picture
const kLeft = 92, kRight = 20, kTop = 14, kHertzTop = 52, kBottom = 50, kBetween = 22, kBeside = 96;  // px
const kHeading = 17;  // above its panel, px
const kMany = 300;  // marks, beyond which they are small
const kBorder = 1.6;  // of lines over cells, px on both sides
const kMostMarks = 3000, kMostJumps = 200;  // in view; more lines of jumps would fill the panel
export const kJumps = 'jumps';  // how a velocity goes over at impacts
const kWhole = 0.6;  // of a mark's size where there are that many

const sameAxis = (a, b) => ['name', 'unit', 'low', 'high', 'scale'].every((key) => a[key] === b[key]);

// Whether the panel below goes on with the same axis, so that its name there is enough.
function sharesAxis(panels, panel) {
  const below = panels.find(({ row, column, columns }) => row === panel.row + 1 && column === panel.column && columns === panel.columns);
  return below !== undefined && sameAxis(panel.x, below.x);
}

const hasHertz = (panel) => panel.row === 0 && panel.x.hertz && panel.x.scale === 'linear';

// The rows of panels with their heights, px: with the names below those that have any.
function rowsOf(panels) {
  return [...new Set(panels.map(({ row }) => row))].map((row) => {
    const inRow = panels.filter((panel) => panel.row === row);
    return {
      row, above: (inRow.some(hasHertz) ? kHertzTop : row === 0 ? kTop : 0) + (inRow.some(({ heading }) => heading) ? kHeading : 0),
      height: kPixels * Math.max(...inRow.map(({ height }) => height)),
      below: inRow.some((panel) => !sharesAxis(panels, panel)) ? kBottom : kBetween,
    };
  });
}

export function chartsHeight(panels) {
  return rowsOf(panels).reduce((sum, { above, height, below }) => sum + above + height + below, 0);
}

// What room is left is for the highest rows.
function grids(panels, size) {
  const rows = rowsOf(panels);
  const highest = Math.max(...rows.map(({ height }) => height));
  const more = Math.max(0, size.height - chartsHeight(panels)) / rows.filter(({ height }) => height === highest).length;
  let top = 0;
  for (const row of rows) {
    row.top = top + row.above;
    if (row.height === highest) row.height += more;
    top = row.top + row.height + row.below;
  }
  return panels.map((panel) => {
    const { top: from, height } = rows.find(({ row }) => row === panel.row);
    const width = (size.width - kLeft - kRight - (panel.columns - 1) * kBeside) / panel.columns;
    return { left: kLeft + panel.column * (width + kBeside), width, top: from, height, outerBoundsMode: 'none' };
  });
}

// One of `drawn`: { panel, i, x, y (AxisScale), ranges: { x, y }, lines } with `lines` as placed() has them.
// `labels`: { things, on }. Dots lie under the chart (dot_layer.js).
function curveSeries({ panel, i, y, ranges, lines }, theme, shows, labels, seen) {
  const common = { xAxisIndex: i, yAxisIndex: i, silent: true, animation: false, clip: true };
  return lines.flatMap((line, k) => {
    const { series } = line;
    if (isCloud(series)) return [];
    const points = shows(series.title) ? pointsOf(line, seen) : [];
    const parts = [];
    const over = 4 + 2 * k;  // those that come later lie on top
    if (series.line) {
      const of = isThinned(line) ? { x: points.map(([x]) => x), y: points.map(([, up]) => up) } : line;
      const curve = { ...common, type: 'line', data: points.length > 0 ? nearAxes(of, ranges.x, ranges.y) : [], showSymbol: false };
      const style = pen(series.look, theme);
      if (panel.cells)  // seen on any colour
        parts.push({ ...curve, id: `border ${i} ${k}`, z: 3, lineStyle: { color: theme.colours.paper, width: style.width + 2 * kBorder, type: 'solid' } });
      parts.push({ ...curve, id: `curve ${i} ${k}`, z: over, lineStyle: style });
    }
    if (series.error) parts.push(errorBars(series, points, { id: `error ${i} ${k}`, z: over }, y, ranges.y, theme, common));
    if (series.marks)
      parts.push({ ...common, id: `marks ${i} ${k}`, type: 'scatter', z: over + 1, ...stamp(series.look, theme, points.length > kMany ? kWhole : 1),
        data: points.map((value, n) => ({ value, name: nameOf(line, n, labels) })).filter(({ value }) => value.every(Number.isFinite)),
        label: markLabel(theme, labels.on && line.of !== undefined), labelLayout: { hideOverlap: true } });
    return parts;
  });
}

// Whether only some of a line are drawn where many are in view.
function isThinned({ series, x, of }) {
  if (series.look.id === kJumps) return x.length > 3 * kMostJumps;
  return series.marks && !series.line && !series.error && !of && !isCloud(series) && x.length > kMostMarks;
}

// Marks evenly, at most so many of what is in view; more jumps of a velocity than a panel holds are none.
function pointsOf(line, { x: [low, high] }) {
  const points = Array.from(line.x, (x, n) => [x, line.y[n]]);
  if (!isThinned(line)) return points;
  const inside = points.filter(([x]) => !(x < low || x > high));
  if (line.series.look.id === kJumps) return inside.length > 3 * kMostJumps ? [] : inside;
  const stride = Math.ceil(inside.length / kMostMarks);
  return inside.filter((_, n) => n % stride === 0);
}

export function isCloud({ dots, look }) { return dots && look.mark === 'dot'; }

function nameOf({ of, series }, n, { things }) { return of && !series.line ? things.kindOf(of[n]).name : ''; }

// The names of lines whose points are of things, for what is in view.
function nameSeries({ i, lines }, theme, shows, { things, on }, inView) {
  const named = on ? lines.filter(({ of, series }) => of && series.line && shows(series.title)) : [];
  return {
    id: `names ${i}`, type: 'scatter', xAxisIndex: i, yAxisIndex: i, silent: true, animation: false, z: 99, symbolSize: 0,
    data: lineNames(named, things, inView), label: markLabel(theme, on), labelLayout: { hideOverlap: true },
  };
}

// A name above its place.
function markLabel(theme, show) {
  return {
    show, formatter: '{b}', position: 'top', distance: 3, fontSize: 11, color: theme.colours.ink,
    textBorderColor: theme.colours.paper, textBorderWidth: 2.5,
  };
}

// Upright strokes; on a logarithmic axis down to its end where they reach to zero.
function errorBars(series, points, own, y, [low], theme, common) {
  const data = points.flatMap(([x], n) => {
    if (!(series.error[n] > 0)) return [];
    const ends = [series.y[n] - series.error[n], series.y[n] + series.error[n]].map((value) => y.of(value));
    return [[x, Number.isFinite(ends[0]) ? ends[0] : low], [x, ends[1]], [NaN, NaN]];
  });
  return { ...common, ...own, type: 'line', data, showSymbol: false, lineStyle: { color: theme.shade(series.look.colour), width: 1.1, type: 'solid' } };
}

// Fills, levels and the remark are on a series of their own.
function groundSeries({ panel, i, x, y, ranges }, theme, shows) {
  const { colours } = theme;
  const areas = panel.fills.filter(({ title }) => shows(title)).map(({ upright, from, to, colour }) => {
    const [name, scale, range] = upright ? ['yAxis', y, ranges.y] : ['xAxis', x, ranges.x];
    const end = (value, border) => { const at = value === null ? NaN : scale.of(value); return Number.isFinite(at) ? at : border; };
    return [{ [name]: end(from, range[0]), itemStyle: { color: theme.shade(colour), opacity: 0.75 } }, { [name]: end(to, range[1]) }];
  });
  const middle = [ranges.x, ranges.y].map(([low, high]) => (low + high) / 2);
  const common = { xAxisIndex: i, yAxisIndex: i, silent: true, animation: false };
  return [{
    ...common, id: `ground ${i}`, type: 'line', data: [], z: 1, markArea: { silent: true, data: areas },
    markLine: {
      symbol: 'none', silent: true, label: { show: false }, lineStyle: { color: colours.faint, type: 'solid', width: 1 },
      data: [...panel.levels.map((level) => ({ yAxis: y.of(level) })), ...(panel.uprights ?? []).map((level) => ({ xAxis: x.of(level) }))]
        .filter((level) => Object.values(level).every(Number.isFinite)),
    },
  }, {
    ...common, id: `remark ${i}`, type: 'scatter', symbolSize: 1, z: 101, data: panel.remark ? [{ value: middle, name: panel.remark }] : [],
    itemStyle: { color: 'transparent' }, label: { ...markLabel(theme, true), position: 'inside', fontSize: 13 },
  }];
}

// Panels whose axes are alike are zoomed together across, and those of a row upright each alone.
function zooms(drawn) {
  const groups = [];
  for (const { panel, i } of drawn) {
    const group = groups.find(([first]) => sameAxis(drawn[first].panel.x, panel.x));
    if (group) group.push(i);
    else groups.push([i]);
  }
  // No deeper than two cells.
  const least = ({ cells }, along) => (cells ? Math.min(100, 200 / cells[along].length) : 1e-6);
  const common = (i, along) => ({ type: 'inside', filterMode: 'none', minSpan: least(drawn[i].panel, along) });
  return [
    ...groups.map((group, k) => ({ ...common(group[0], 'columns'), id: `across ${k}`, xAxisIndex: group })),
    ...drawn.map(({ i }) => ({ ...common(i, 'rows'), id: `upright ${i}`, yAxisIndex: [i], zoomOnMouseWheel: 'shift' })),
  ];
}

// Lines at the tics are for panels without cells.
const unlined = ({ cells }) => (cells ? { splitLine: { show: false } } : {});

// The cell that is opened, by its place; or null.
export function markedSeries(place, theme) {
  return [{
    id: 'marked', type: 'scatter', data: place ? [place] : [], silent: true, symbol: 'rect', symbolSize: 11, z: 100,
    itemStyle: { color: 'transparent', borderColor: theme.colours.ink, borderWidth: 2.5, opacity: 1, shadowColor: theme.colours.paper, shadowBlur: 3 },
  }];
}

// `inView(i)`: { x, y } of a panel; `marked`: as of markedSeries().
export function chartsOption({ drawn, theme, shows, labels, inView, size, marked }) {
  const { colours } = theme;
  const panels = drawn.map(({ panel }) => panel);
  const across = drawn.map(({ panel, i, x, ranges }) => {
    const made = axis(colours, sharesAxis(panels, panel) ? '' : x.name, ...ranges.x, { gridIndex: i, nameGap: 30, ...unlined(panel) });
    if (sharesAxis(panels, panel)) made.axisLabel = { show: false };
    return made;
  });
  const dataZoom = zooms(drawn);
  for (const { panel, i, ranges } of drawn)
    if (hasHertz(panel)) {
      dataZoom.find(({ xAxisIndex }) => xAxisIndex?.includes(i)).xAxisIndex.push(across.length);
      across.push({ ...hertzAxis(colours, ...ranges.x), gridIndex: i });
    }
  const places = grids(panels, size);
  return {
    ...kCommon, grid: places, xAxis: across,
    title: panels.flatMap(({ heading }, i) => (heading ? [{
      text: heading, left: places[i].left, top: places[i].top - kHeading, padding: 0,
      textStyle: { color: colours.ink, fontSize: 12, fontWeight: 'normal' },
    }] : [])),
    yAxis: drawn.map(({ i, y, ranges }) => axis(colours, y.name, ...ranges.y, {
      gridIndex: i, nameGap: 52, splitNumber: 4, ...unlined(panels[i]), nameTextStyle: { color: colours.ink, fontSize: 12, lineHeight: 14 },
    })),
    series: drawn.flatMap((one) => {
      const seen = inView(one.i);
      return [...groundSeries(one, theme, shows), ...curveSeries(one, theme, shows, labels, seen), nameSeries(one, theme, shows, labels, seen)];
    }).concat(markedSeries(marked, theme)),
    dataZoom,
  };
}

// What depends on what is in view, to be merged into an option: tics of logarithmic axes, names of lines,
// what is thinned.
export function chartsInView({ drawn, theme, shows, labels, inView }) {
  const panels = drawn.map(({ panel }) => panel);
  return {
    xAxis: drawn.map(({ panel, x }, i) => {
      const tics = x.tics(...inView(i).x);
      return sharesAxis(panels, panel) && tics.axisTick ? { axisTick: tics.axisTick } : tics;
    }),
    yAxis: drawn.map(({ y }, i) => y.tics(...inView(i).y)),
    series: drawn.flatMap((one) => [
      ...(labels.on ? [nameSeries(one, theme, shows, labels, inView(one.i))] : []),
      ...(one.lines.some(isThinned) ? curveSeries(one, theme, shows, labels, inView(one.i)) : []),
    ]),
  };
}
