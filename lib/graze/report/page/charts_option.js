// A chart of the program (report/chart) as ECharts draws it: rows of panels with curves, marks, bars of
// error, fills, levels and words.
import { axis, hertzAxis, kCommon } from './echarts_parts.js';
import { markLabel } from './diagram_option.js';
import { pen, stamp } from './marks.js';

const kPixels = 58;  // of a centimetre of a picture
const kLeft = 92, kRight = 20, kTop = 14, kHertzTop = 52, kBottom = 50, kBetween = 22, kBeside = 96;  // px
const kHeading = 17;  // above its panel, px
const kMany = 300;  // marks, beyond which they are small
const kWhole = 0.6;  // of a mark's size where there are that many

// Panels in their order, with their row and column.
export function panelsOf(view) {
  return view.rows.flatMap((row, r) => row.map((panel, c) => ({ ...panel, row: r, column: c, columns: row.length })));
}

const sameAxis = (a, b) => ['name', 'unit', 'low', 'high', 'scale'].every((key) => a[key] === b[key]);

// Whether the panel below goes on with the same axis, so that its name there is enough.
function sharesAxis(panels, panel) {
  const below = panels.find(({ row, column, columns }) => row === panel.row + 1 && column === panel.column && columns === panel.columns);
  return below !== undefined && sameAxis(panel.x, below.x);
}

const hasHertz = (panel) => panel.row === 0 && panel.x.hertz && panel.x.scale === 'linear';

// The rows' heights, px: with the names below those that have any.
function rowHeights(view, panels) {
  return view.rows.map((row, r) => {
    const inRow = panels.filter((panel) => panel.row === r);
    return {
      above: (inRow.some(hasHertz) ? kHertzTop : r === 0 ? kTop : 0) + (inRow.some(({ heading }) => heading) ? kHeading : 0),
      height: kPixels * Math.max(...row.map(({ height }) => height)),
      below: inRow.some((panel) => !sharesAxis(panels, panel)) ? kBottom : kBetween,
    };
  });
}

export function chartsHeight(view) {
  return rowHeights(view, panelsOf(view)).reduce((sum, { above, height, below }) => sum + above + height + below, 0);
}

function grids(view, panels, size) {
  const rows = rowHeights(view, panels);
  const more = Math.max(0, size.height - chartsHeight(view)) / rows.length;
  const tops = [];
  rows.reduce((top, { above, height, below }, r) => (tops[r] = top + above, top + above + height + more + below), 0);
  return panels.map(({ row, column, columns }) => {
    const width = (size.width - kLeft - kRight - (columns - 1) * kBeside) / columns;
    return { left: kLeft + column * (width + kBeside), width, top: tops[row], height: rows[row].height + more, outerBoundsMode: 'none' };
  });
}

// One of `drawn`: { panel, i, x, y (AxisScale), ranges: { x, y } }.
function curveSeries({ panel, i, x, y, ranges }, theme, shows) {
  const common = { xAxisIndex: i, yAxisIndex: i, silent: true, animation: false, clip: true };
  return panel.series.flatMap((series, k) => {
    const count = shows(series.title) ? series.x.length : 0;
    const points = Array.from({ length: count }, (_, n) => [x.of(series.x[n]), y.of(series.y[n])]);
    const parts = [];
    const over = 4 + 2 * k;  // those that come later lie on top
    if (series.line)
      parts.push({ ...common, id: `curve ${i} ${k}`, type: 'line', data: points, showSymbol: false, z: over, lineStyle: pen(series.look, theme) });
    if (series.error) parts.push(errorBars(series, points, { id: `error ${i} ${k}`, z: over }, y, ranges.y, theme, common));
    if (series.marks)
      parts.push({ ...common, id: `marks ${i} ${k}`, type: 'scatter', data: points.filter((point) => point.every(Number.isFinite)), z: over + 1,
        ...(series.dots ? { ...stamp(series.look, theme), symbol: 'circle', symbolSize: points.length > kMany ? 2 : 4, large: true, largeThreshold: kMany }
          : stamp(series.look, theme, points.length > kMany ? kWhole : 1)) });
    return parts;
  });
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
      data: panel.levels.map((level) => ({ yAxis: y.of(level) })).filter(({ yAxis }) => Number.isFinite(yAxis)),
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
  const common = { type: 'inside', filterMode: 'none', minSpan: 1e-6 };
  return [
    ...groups.map((group, k) => ({ ...common, id: `across ${k}`, xAxisIndex: group })),
    ...drawn.map(({ i }) => ({ ...common, id: `upright ${i}`, yAxisIndex: [i], zoomOnMouseWheel: 'shift' })),
  ];
}

export function chartsOption(view, drawn, theme, shows, size) {
  const { colours } = theme;
  const panels = drawn.map(({ panel }) => panel);
  const across = drawn.map(({ panel, i, x, ranges }) => {
    const made = axis(colours, sharesAxis(panels, panel) ? '' : x.name, ...ranges.x, { gridIndex: i, nameGap: 30 });
    if (sharesAxis(panels, panel)) made.axisLabel = { show: false };
    return made;
  });
  const dataZoom = zooms(drawn);
  for (const { panel, i, ranges } of drawn)
    if (hasHertz(panel)) {
      dataZoom.find(({ xAxisIndex }) => xAxisIndex?.includes(i)).xAxisIndex.push(across.length);
      across.push({ ...hertzAxis(colours, ...ranges.x), gridIndex: i });
    }
  const places = grids(view, panels, size);
  return {
    ...kCommon, grid: places, xAxis: across,
    title: panels.flatMap(({ heading }, i) => (heading ? [{
      text: heading, left: places[i].left, top: places[i].top - kHeading, padding: 0,
      textStyle: { color: colours.ink, fontSize: 12, fontWeight: 'normal' },
    }] : [])),
    yAxis: drawn.map(({ i, y, ranges }) => axis(colours, y.name, ...ranges.y, {
      gridIndex: i, nameGap: 52, splitNumber: 4, nameTextStyle: { color: colours.ink, fontSize: 12, lineHeight: 14 },
    })),
    series: drawn.flatMap((one) => [...groundSeries(one, theme, shows), ...curveSeries(one, theme, shows)]),
    dataZoom,
  };
}

// Logarithmic axes' tics for what is in view. `inView(i)`: { x, y } of a panel.
export function chartsTics(drawn, inView) {
  const panels = drawn.map(({ panel }) => panel);
  return {
    xAxis: drawn.map(({ panel, x }, i) => {
      const tics = x.tics(...inView(i).x);
      return sharesAxis(panels, panel) && tics.axisTick ? { axisTick: tics.axisTick } : tics;
    }),
    yAxis: drawn.map(({ y }, i) => y.tics(...inView(i).y)),
  };
}
