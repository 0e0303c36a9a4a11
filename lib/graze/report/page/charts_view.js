// Any chart of the program: the pointer or the arrow keys go from point to point, names in the legend
// hide what has that name. What its points are of may stand over any two of its numbers, and opens.
import { keepZoom, partInView } from './axes_in_view.js';
import { AxisChoice } from './axis_choice.js';
import { AxisScale } from './axis_scale.js';
import { openCell } from './cell_panel.js';
import { Cells } from './cells.js';
import { chartsTable } from './charts_csv.js';
import { chartsHeight, chartsInView, chartsOption, isCloud, markedSeries } from './charts_option.js';
import { DotLayer } from './dot_layer.js';
import { init } from './echarts_parts.js';
import { ExportTools } from './export_tools.js';
import { measure } from './format.js';
import { Hover } from './hover.js';
import { LabelTool } from './label_tool.js';
import { Legend, chartEntries } from './legend.js';
import { nearestInPanel } from './nearest.js';
import { OrbitPanel } from './orbit_panel.js';
import { placed, Things } from './things.js';
import { ZoomTools } from './zoom_tools.js';

const kReach = 14, kReachOverCells = 8;  // px
const kMostDecades = 12, kMostDecadesOfThings = 6;  // of a logarithmic axis: below lies where speeds vanish

// What an axis spans, as numbers along it: what the program says, but of a logarithm what is drawn.
// `name`: "x" or "y".
function rangeOf(name, scale, axis, lines) {
  const given = [axis.low, axis.high].map((value) => scale.of(value));
  if (scale.kind === 'linear' || (axis.given && given.every(Number.isFinite))) return given;
  const decade = scale.kind === 'log' ? 1 : 20;
  let least = Infinity, most = -Infinity;
  for (const line of lines)
    for (let k = 0; k < line.x.length; ++k) {
      if (!Number.isFinite(line.x[k]) || !Number.isFinite(line.y[k])) continue;
      least = Math.min(least, line[name][k]);
      most = Math.max(most, line[name][k]);
    }
  if (!(least <= most)) return [0, decade];
  if (axis.key && axis.low >= 0) most = Math.min(most, given[1]);
  least = Math.max(least, most - (axis.key ? kMostDecadesOfThings : kMostDecades) * decade);
  const room = Math.max(0.05 * (most - least), 0.03 * decade);
  return [least - room, most + room];
}

export class ChartsView {
  constructor(view, orbits, theme) {
    Object.assign(this, { view, orbits, theme, things: view.things ? new Things(view.things) : null });
    this.stage = document.getElementById('stage');
    this.root = document.getElementById('chart');
    this.chart = init(this.root, null, { renderer: 'canvas' });
    this.dots = new DotLayer(document.getElementById('dots'));
    this.hover = new Hover(document.getElementById('hover'), document.getElementById('ring'));
    this.legend = new Legend(document.getElementById('legend'), theme, [], () => this.draw());
    this.zoom = new ZoomTools(this.chart, this.root);
    this.labels = new LabelTool(this.things?.kinds.some(({ name }) => name) ?? false, () => this.draw());
    this.export = new ExportTools({
      theme, chart: this.chart, legend: this.legend, under: this.dots.canvas, bar: () => this.cells?.bar ?? null, table: () => this.table(),
    });
    if (this.things)
      this.panel = new OrbitPanel({ ...view, parameter: this.things.parameter }, theme, () => window.dispatchEvent(new Event('resize')), () => this.mark(null));
    const [first] = view.rows[0] ?? [];
    if (first?.x.key)
      this.axes = new AxisChoice(this.things.axes, { x: this.things.number(first.x.key), y: this.things.number(first.y.key) }, () => this.place());
    if (first?.cells)
      this.cells = new Cells(this.dots.canvas, first, { x: new AxisScale(first.x), y: new AxisScale(first.y) }, this.things, view.looks.none, () => this.place());
    document.getElementById('observables').hidden = !this.axes && !(this.cells?.numbers.length > 0);
    this.opens = this.cells ? 'the cell' : this.things?.kept.length > 0 ? 'the orbit' : '';
    document.getElementById('hint').textContent = `wheel: zoom · shift + wheel: zoom upright · drag: move${this.opens ? ` · click: ${this.opens}` : ''}`;
    this.place();
    this.listen();
  }

  // The panels in their order, over what was chosen for the axes.
  panels() {
    const all = this.view.rows.flatMap((row, r) => row.map((panel, c) => ({ ...panel, row: r, column: c, columns: row.length })));
    if (!this.axes) return all;
    const { x, y } = this.axes.scales;
    const axis = ({ quantity, kind }) => ({ ...quantity, scale: kind });
    const [first, ...strips] = all;
    const levels = ({ quantity }) => (quantity.level === undefined ? [] : [quantity.level]);
    const { series = [], remark = '' } = this.layout() ?? {};
    const over = { ...first, series, remark, x: axis(x), y: axis(y), levels: levels(y), uprights: levels(x) };
    return [over, ...(x.quantity === this.things.parameter ? strips.map((strip) => ({ ...strip, x: over.x })) : [])];
  }

  // The number that tells how many points a thing has; null where it has one.
  get counted() {
    const { x, y } = this.axes.scales;
    return [y.quantity, x.quantity].find(({ single }) => !single) ?? null;
  }

  // The panel whose points the chosen numbers have.
  layout() {
    return [this.view.rows[0][0], ...this.view.layouts].find(({ y: { key } }) => (
      this.counted ? key === this.counted.key : this.things.number(key).single));
  }

  place() {
    this.drawn = this.panels().map((panel, i) => {
      const scales = i === 0 && this.axes ? this.axes.scales
        : { x: new AxisScale(panel.x, panel.x.scale), y: new AxisScale(panel.y, panel.y.scale) };
      const lines = panel.series.map((series) => placed(series, scales, this.things)).filter(({ drawn }) => drawn);
      const range = (name) => rangeOf(name, scales[name], panel[name], lines);
      return { panel, i, ...scales, lines, ranges: { x: range('x'), y: range('y') } };
    });
    this.stage.style.height = `max(${chartsHeight(this.drawn.map(({ panel }) => panel))}px, min(68vh, 720px))`;
    this.fit();
    this.legend.entries = chartEntries(this.drawn, this.view.legend, this.cells?.entries ?? []);
    this.legend.draw();
    if (this.axes) {
      this.chosen = null;
      if (this.chart.getOption()) this.zoom.whole();
    }
    this.draw();
  }

  // Whether the chart had another size than its place.
  fit() {
    const { clientWidth, clientHeight } = this.root;
    if (this.chart.getWidth() === clientWidth && this.chart.getHeight() === clientHeight) return false;
    this.chart.resize();
    return true;
  }

  shows(title) { return title === '' || this.legend.shows(title); }

  listen() {
    this.theme.onChange(() => { this.legend.draw(); this.draw(); });
    new ResizeObserver(() => { if (this.fit()) this.draw(); }).observe(this.stage);
    this.chart.on('datazoom', () => this.zoomed());
    const zr = this.chart.getZr();
    zr.on('mousemove', (event) => {
      const found = this.nearest(event.offsetX, event.offsetY);
      zr.setCursorStyle(found && (found.cell !== undefined || this.orbitOf(found) >= 0) ? 'pointer' : 'default');
      this.show(found);
    });
    zr.on('globalout', () => this.show(null));
    zr.on('click', (event) => {
      const place = [event.offsetX, event.offsetY];
      const cell = this.cells?.cellAt(this.plane(0), place) ?? null;
      const found = cell === null ? this.nearest(...place) : { cell };
      if (found) this.open(found);
    });
    this.root.addEventListener('keydown', (event) => this.key(event));
  }

  // What of a panel is in view, as numbers along its axes.
  inView(i, dataZoom = this.chart.getOption()?.dataZoom ?? []) {
    const has = (indices) => [indices ?? []].flat().includes(i);
    const { ranges } = this.drawn[i];
    return {
      x: partInView(ranges.x, dataZoom.find(({ xAxisIndex }) => has(xAxisIndex))),
      y: partInView(ranges.y, dataZoom.find(({ yAxisIndex }) => has(yAxisIndex))),
    };
  }

  get picture() {
    const dataZoom = this.chart.getOption()?.dataZoom;
    return {
      drawn: this.drawn, theme: this.theme, shows: (title) => this.shows(title), labels: { things: this.things, on: this.labels.on && this.things !== null },
      inView: (i) => this.inView(i, dataZoom), size: { width: this.root.clientWidth, height: this.root.clientHeight },
      marked: this.marked ?? null,
    };
  }

  draw() {
    const option = chartsOption(this.picture);
    keepZoom(this.chart, option);
    this.chart.setOption(option, { notMerge: true });
    if (this.drawn.some(({ x, y }) => x.kind === 'log' || y.kind === 'log')) this.chart.setOption(chartsInView(this.picture));
    this.show(null);
    this.cells?.paint(this.theme, (title) => this.shows(title));
    this.drawInView();
  }

  table() { return chartsTable(this); }

  // The cell that is opened, or null.
  mark(cell) {
    if (!this.cells) return;
    this.marked = cell === null ? null : this.cells.placeOf(cell);
    this.chart.setOption({ series: markedSeries(this.marked, this.theme) });
  }

  zoomed() {
    this.show(null);
    this.drawInView();
    clearTimeout(this.waiting);
    // ECharts takes no option while it tells of a zoom.
    this.waiting = setTimeout(() => this.chart.setOption(chartsInView(this.picture)));
  }

  drawInView() {
    const { dataZoom } = this.chart.getOption();
    if (this.cells) this.cells.draw(this.plane(0, dataZoom));
    else this.dots.draw(this.drawn.map(({ i, lines }) => ({
      plane: this.plane(i, dataZoom),
      clouds: lines.filter(({ series }) => isCloud(series) && this.shows(series.title))
        .map(({ x, y, series: { look } }) => ({ x, y, colour: this.theme.shade(look.colour), fades: look.id === 'wild' })),
    })));
    const told = this.drawn.map(({ panel, x, y, i }) => {
      const seen = this.inView(i, dataZoom);
      const range = (scale, [low, high]) => `${scale.measure(low)} to ${scale.measure(high)}`;
      return `${plain(panel.y.name)} from ${range(y, seen.y)} over ${plain(panel.x.name)} from ${range(x, seen.x)}`;
    });
    const map = this.cells ? `Map of the ${this.cells.number?.name ?? this.cells.name}: ` : '';
    this.root.setAttribute('aria-label', `${map}${told.join('; ')}. Arrow keys go from ${this.cells ? 'cell to cell' : 'point to point'}${this.opens ? `, Enter opens ${this.opens}` : ''}.`);
  }

  // Where a panel is, px, and what of it is in view.
  plane(i, dataZoom) {
    const { x, y, width, height } = this.chart.getModel().getComponent('grid', i).coordinateSystem.getRect();
    return { left: x, top: y, right: x + width, bottom: y + height, ...this.inView(i, dataZoom) };
  }

  nearest(px, py) {
    for (const { i, lines } of this.drawn) {
      const plane = this.plane(i);
      if (px < plane.left - kReach || px > plane.right + kReach || py < plane.top - kReach || py > plane.bottom + kReach) continue;
      const shown = lines.filter(({ series }) => this.shows(series.title));
      const found = nearestInPanel(shown, plane, [px, py], this.cells ? kReachOverCells : kReach);
      if (found) return { panel: i, ...found };
      const cell = this.cells?.cellAt(plane, [px, py]) ?? null;
      return cell === null ? null : { cell };
    }
    return null;
  }

  // Null hides what was shown.
  show(found) {
    if (!found) return this.hover.hide();
    this.chosen = found;
    if (found.cell !== undefined) return this.showCell(found.cell);
    const { panel: i, line, node } = found;
    const [x, y] = this.chart.convertToPixel({ gridIndex: i }, [line.x[node], line.y[node]]);
    const thing = this.thingOf(found);
    const title = thing < 0 ? line.series.title || plain(this.drawn[i].panel.y.name) : this.things.kindOf(thing).title;
    return this.hover.show({ x, y }, title, this.valuesOf(found), this.orbitOf(found) >= 0 ? 'click: the orbit' : '');
  }

  showCell(cell) {
    const [x, y] = this.chart.convertToPixel({ gridIndex: 0 }, this.cells.placeOf(cell));
    this.hover.show({ x, y }, this.cells.titleOf(cell), this.cells.valuesOf(cell, 5),
      this.cells.orbitOf(cell) < 0 ? 'click: how to follow it' : 'click: what it does');
  }

  // Names and values.
  valuesOf({ panel: i, line, node }) {
    const { panel, x, y } = this.drawn[i];
    const { series } = line;
    const thing = this.thingOf({ line, node });
    const error = series.error?.[node] > 0 ? ` ± ${measure(panel.y, series.error[node], 3)}` : '';
    if (thing < 0 || series.y)
      return [[plain(panel.x.name), measure(panel.x, x.back(line.x[node]), 7)], [plain(panel.y.name), measure(panel.y, y.back(line.y[node]), 6) + error]];
    // Where a point stands for all of a motion, its impacts are not told.
    const numbers = new Set([this.things.parameter, y.quantity, x.quantity, ...this.things.numbers]);
    const told = [...numbers].filter((number) => number.single || this.counted)
      .map((number) => [number, this.things.valueOf(number, thing, line.which[node])])
      .filter(([, value]) => Number.isFinite(value))
      .map(([number, value]) => [number.name, measure(number, value, number === this.things.parameter ? 7 : 5)]);
    return [...told, ...(this.things.more[thing] ?? [])];
  }

  // -1 where it is of none.
  thingOf({ line, node }) { return line.of?.[node] ?? -1; }
  orbitOf(found) {
    const thing = this.thingOf(found);
    return thing < 0 ? -1 : this.things.orbitOf(thing);
  }

  open(found) {
    this.show(found);
    if (found.cell !== undefined) this.openThing(found.cell);
    else if (this.orbitOf(found) >= 0) this.openThing(this.thingOf(found));
  }

  openThing(thing) {
    const { things } = this;
    if (this.cells?.has(thing)) {
      this.show({ cell: thing });
      this.mark(thing);
      return openCell(this.panel, this.cells, this.view.cells, this.orbits, thing);
    }
    const { parameter } = things;
    return this.panel.open(this.orbits.get(things.orbitOf(thing)), parameter ? things.valueOf(parameter, thing) : null);
  }

  key(event) {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (step && this.cells) this.show({ cell: this.cells.beside(this.chosen?.cell, step[0], -step[1]) });
    else if (step) this.step(...step);
    else if (event.key === 'Enter' && this.chosen) this.open(this.chosen);
    else return;
    event.preventDefault();
  }

  // Along a series, or to the next one that is shown, in the order of the legend; dots come last.
  step(by, next) {
    const places = this.legend.entries.map(({ title }) => title);
    const order = ({ line: { series } }) => places.indexOf(series.title) + (isCloud(series) ? places.length : 0);
    const all = this.drawn.flatMap(({ lines, i }) => lines.map((line) => ({ panel: i, line })))
      .filter(({ line }) => this.shows(line.series.title));
    if (this.things) all.sort((a, b) => a.panel - b.panel || order(a) - order(b));
    if (all.length === 0) return;
    const at = all.findIndex(({ line }) => line === this.chosen?.line);
    const to = at < 0 ? all[0] : all[Math.max(0, Math.min(all.length - 1, at + next))];
    const { x, y, of, series } = to.line;
    const isThere = (node) => Number.isFinite(x[node]) && Number.isFinite(y[node]);
    const isOther = (node) => !isCloud(series) || !of || of[node] !== of[this.chosen?.node];
    // Rows of a sweep may come falling.
    const along = (by || 1) * (isCloud(series) && x[0] > x[x.length - 1] ? -1 : 1);
    let node = at < 0 || next ? (along < 0 ? x.length - 1 : 0) : this.chosen.node + along;
    while (node >= 0 && node < x.length && !(isThere(node) && (at < 0 || next || isOther(node)))) node += along;
    if (isThere(node)) this.show({ ...to, node });
  }
}

// An axis' name in one line.
export function plain(name) { return name.trim().replaceAll('\n', ' '); }
