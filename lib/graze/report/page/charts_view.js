// Any chart of the program: the pointer or the arrow keys go from point to point, names in the legend
// hide what has that name.
import { keepZoom, partInView } from './axes_in_view.js';
import { AxisScale } from './axis_scale.js';
import { chartsHeight, chartsOption, chartsTics, panelsOf } from './charts_option.js';
import { CsvTable, digits } from './csv_table.js';
import { columnOf } from './diagram_csv.js';
import { init } from './echarts_parts.js';
import { ExportTools } from './export_tools.js';
import { measure } from './format.js';
import { Hover } from './hover.js';
import { Legend } from './legend.js';
import { cellSwatch, lookSwatch } from './marks.js';
import { nearestNode } from './nearest.js';
import { ZoomTools } from './zoom_tools.js';

const kReach = 14;       // px
const kMostDecades = 12;  // of a logarithmic axis

// What an axis spans, as numbers along it: what the program says, but of a logarithm what is drawn of
// `points`, SI. `name`: "x" or "y".
function rangeOf(name, scales, axis, points) {
  const scale = scales[name];
  const given = [axis.low, axis.high].map((value) => scale.of(value));
  if (axis.scale === 'linear' || (axis.given && given.every(Number.isFinite))) return given;
  const decade = axis.scale === 'log' ? 1 : 20;
  let least = Infinity, most = -Infinity;
  for (const point of points) {
    const [x, y] = [scales.x.of(point[0]), scales.y.of(point[1])];
    if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
    least = Math.min(least, name === 'x' ? x : y);
    most = Math.max(most, name === 'x' ? x : y);
  }
  if (!(least <= most)) return [0, decade];
  least = Math.max(least, most - kMostDecades * decade);
  const room = Math.max(0.05 * (most - least), 0.03 * decade);
  return [least - room, most + room];
}

export class ChartsView {
  constructor(view, theme) {
    Object.assign(this, { view, theme });
    this.stage = document.getElementById('stage');
    this.root = document.getElementById('chart');
    document.getElementById('observables').hidden = true;
    document.getElementById('hint').textContent = 'wheel: zoom · shift + wheel: zoom upright · drag: move';
    this.stage.style.height = `max(${chartsHeight(view)}px, min(68vh, 720px))`;
    this.drawn = panelsOf(view).map((panel, i) => {
      const x = new AxisScale(panel.x, panel.x.scale), y = new AxisScale(panel.y, panel.y.scale);
      const points = panel.series.flatMap((series) => Array.from(series.x, (value, k) => [value, series.y[k]]));
      const range = (name) => rangeOf(name, { x, y }, panel[name], points);
      return { panel, i, x, y, ranges: { x: range('x'), y: range('y') } };
    });
    this.chart = init(this.root, null, { renderer: 'canvas' });
    this.hover = new Hover(document.getElementById('hover'), document.getElementById('ring'));
    this.legend = new Legend(document.getElementById('legend'), theme, this.entries(), () => this.draw());
    this.zoom = new ZoomTools(this.chart, this.root);
    this.export = new ExportTools({ theme, chart: this.chart, legend: this.legend, table: () => this.table() });
    this.lines = this.drawn.map(({ panel, x, y }) => panel.series.map((series) => ({
      series, x: Float64Array.from(series.x, (value) => x.of(value)), y: Float64Array.from(series.y, (value) => y.of(value)),
    })));
    this.draw();
    this.listen();
  }

  // One for each title, as it looks where it comes first.
  entries() {
    const entries = new Map();
    for (const { panel } of this.drawn) {
      for (const { title, look, line, marks } of panel.series)
        if (title && !entries.has(title)) entries.set(title, { type: title, title, swatch: (theme) => lookSwatch(look, theme, { line, marks }) });
      for (const { title, colour } of panel.fills)
        if (title && !entries.has(title)) entries.set(title, { type: title, title, swatch: (theme) => cellSwatch(theme.shade(colour)) });
    }
    return [...entries.values()];
  }

  shows(title) { return title === '' || this.legend.shows(title); }

  listen() {
    this.theme.onChange(() => { this.legend.draw(); this.draw(); });
    new ResizeObserver(() => {
      const { clientWidth, clientHeight } = this.root;
      if (this.chart.getWidth() === clientWidth && this.chart.getHeight() === clientHeight) return;
      this.chart.resize();
      this.draw();
    }).observe(this.stage);
    this.chart.on('datazoom', () => this.zoomed());
    const zr = this.chart.getZr();
    zr.on('mousemove', (event) => {
      const found = this.nearest(event.offsetX, event.offsetY);
      if (found) this.show(found);
      else this.hover.hide();
    });
    zr.on('globalout', () => this.hover.hide());
    this.root.addEventListener('keydown', (event) => this.key(event));
  }

  // What of a panel is in view, as numbers along its axes.
  inView(i, dataZoom = this.chart.getOption().dataZoom) {
    const has = (indices) => [indices ?? []].flat().includes(i);
    const { ranges } = this.drawn[i];
    return {
      x: partInView(ranges.x, dataZoom.find(({ xAxisIndex }) => has(xAxisIndex))),
      y: partInView(ranges.y, dataZoom.find(({ yAxisIndex }) => has(yAxisIndex))),
    };
  }

  draw() {
    const size = { width: this.root.clientWidth, height: this.root.clientHeight };
    const option = chartsOption(this.view, this.drawn, this.theme, (title) => this.shows(title), size);
    keepZoom(this.chart, option);
    this.chart.setOption(option, { notMerge: true });
    this.hover.hide();
    this.tellTics();
  }

  zoomed() {
    this.hover.hide();
    clearTimeout(this.waiting);
    // ECharts takes no option while it tells of a zoom.
    this.waiting = setTimeout(() => this.tellTics());
  }

  tellTics() {
    const { dataZoom } = this.chart.getOption();
    this.chart.setOption(chartsTics(this.drawn, (i) => this.inView(i, dataZoom)));
    const told = this.drawn.map(({ panel, x, y }, i) => {
      const seen = this.inView(i, dataZoom);
      const range = (scale, [low, high]) => `${scale.measure(low)} to ${scale.measure(high)}`;
      return `${plain(panel.y.name)} from ${range(y, seen.y)} over ${plain(panel.x.name)} from ${range(x, seen.x)}`;
    });
    this.root.setAttribute('aria-label', `${told.join('; ')}. Arrow keys go from point to point.`);
  }

  box(i) { return this.chart.getModel().getComponent('grid', i).coordinateSystem.getRect(); }

  nearest(px, py) {
    const i = this.drawn.findIndex((_, k) => {
      const { x, y, width, height } = this.box(k);
      return px >= x - kReach && px <= x + width + kReach && py >= y - kReach && py <= y + height + kReach;
    });
    if (i < 0) return null;
    const { x, y, width, height } = this.box(i);
    const seen = this.inView(i);
    const perPixel = { x: (seen.x[1] - seen.x[0]) / width, y: (seen.y[1] - seen.y[0]) / height };
    const place = { x: seen.x[0] + (px - x) * perPixel.x, y: seen.y[1] - (py - y) * perPixel.y };
    // Marks without a line are points alone.
    const shown = this.lines[i].filter(({ series }) => this.shows(series.title));
    const points = shown.filter(({ series }) => !series.line).map((line) => alone(line));
    const found = nearestNode([...shown.filter(({ series }) => series.line), ...points], place, perPixel, kReach, () => true);
    return found && { panel: i, line: found.line.of ?? found.line, node: found.line.of ? found.node / 2 : found.node };
  }

  show(found) {
    this.chosen = found;
    const { panel: i, line, node } = found;
    const { panel } = this.drawn[i];
    const { series } = line;
    const [x, y] = this.chart.convertToPixel({ gridIndex: i }, [line.x[node], line.y[node]]);
    const error = series.error?.[node] > 0 ? ` ± ${measure(panel.y, series.error[node], 3)}` : '';
    this.hover.show({ x, y }, series.title || plain(panel.y.name), [
      [plain(panel.x.name), measure(panel.x, series.x[node], 7)],
      [plain(panel.y.name), measure(panel.y, series.y[node], 6) + error],
    ], '');
  }

  // Left and right along a series, up and down to the next one that is shown.
  key(event) {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!step) return;
    event.preventDefault();
    const all = this.lines.flatMap((lines, panel) => lines.map((line) => ({ panel, line })))
      .filter(({ line }) => this.shows(line.series.title) && line.x.length > 0);
    if (all.length === 0) return;
    const at = all.findIndex(({ line }) => line === this.chosen?.line);
    const next = at < 0 ? all[0] : all[Math.max(0, Math.min(all.length - 1, at + step[1]))];
    const isThere = (node) => Number.isFinite(next.line.x[node]) && Number.isFinite(next.line.y[node]);
    const along = step[0] || 1;
    let node = at < 0 || step[1] ? 0 : this.chosen.node + step[0];
    while (node >= 0 && node < next.line.x.length && !isThere(node)) node += along;
    if (isThere(node)) this.show({ ...next, node });
  }

  // Of each panel those of x and of y; upright axes of one name are told apart by their panels.
  columns() {
    const named = this.drawn.map(({ x, y }) => [columnOf(x), columnOf(y)].map((column) => ({ ...column, name: plain(column.name) })));
    const upright = named.map(([, { name }]) => name);
    return named.map(([x, y], i) => [x, upright.indexOf(y.name) === i ? y : { ...y, name: `${y.name}, panel ${i + 1}` }]);
  }

  // The points in view of all that the legend shows.
  table() {
    const table = new CsvTable(['series']);
    const axes = this.columns();
    for (const [x, y] of axes) for (const { name } of [x, y]) table.column(name);
    this.lines.forEach((lines, i) => {
      const [x, y] = axes[i];
      const seen = this.inView(i);
      for (const line of lines) {
        if (!this.shows(line.series.title)) continue;
        const { error } = line.series;
        for (let k = 0; k < line.x.length; ++k) {
          if (!(line.x[k] >= seen.x[0] && line.x[k] <= seen.x[1] && line.y[k] >= seen.y[0] && line.y[k] <= seen.y[1])) continue;
          const cells = [['series', line.series.title], [x.name, x.text(line.x[k])], [y.name, y.text(line.y[k])]];
          if (error) cells.push([`± ${y.name}`, digits(this.drawn[i].panel.y.factor * error[k])]);
          table.row(...cells);
        }
      }
    });
    return table;
  }
}

// An axis' name in one line.
function plain(name) { return name.replaceAll('\n', ' '); }

// The same points, none next to another.
function alone(line) {
  const spread = (values) => Float64Array.from({ length: 2 * values.length }, (_, i) => (i % 2 ? NaN : values[i / 2]));
  return { of: line, x: spread(line.x), y: spread(line.y) };
}
