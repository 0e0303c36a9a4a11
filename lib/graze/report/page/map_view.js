// A map: cells of a plane, coloured by what the motion settles on there or by a number of it. The
// pointer or the arrow keys choose a cell, a click or Enter tells all of it and how to follow it.
import { keepZoom, planeInView } from './axes_in_view.js';
import { cellCommand } from './cell_command.js';
import { CellAxis, CellLayer, pixelOf } from './cell_layer.js';
import { barTics, fillBar, pixelScale } from './colour_bar.js';
import { axis, hertzAxis, init, kCommon } from './echarts_parts.js';
import { ExportTools } from './export_tools.js';
import { axisName, measure } from './format.js';
import { Hover } from './hover.js';
import { LabelTool } from './label_tool.js';
import { Legend } from './legend.js';
import { lociEntries, lociSeries, nearestOfLoci } from './loci_layer.js';
import { mapTable } from './map_csv.js';
import { cellSwatch } from './marks.js';
import { OrbitPanel } from './orbit_panel.js';
import { ZoomTools } from './zoom_tools.js';

const kReach = 8;  // px

export class MapView {
  constructor(view, orbits, theme) {
    Object.assign(this, { view, orbits, theme, cells: view.cells });
    this.kinds = { key: 'attractor', name: view.cells?.name ?? 'loci' };
    this.quantities = [this.kinds, ...view.numbers];
    this.shown = this.quantities.find(({ key }) => key === view.shown) ?? this.kinds;
    // Loci alone have no cells.
    this.columns = new CellAxis(view.x.values);
    this.rows = new CellAxis(view.y.values);
    this.root = document.getElementById('chart');
    this.chart = init(this.root, null, { renderer: 'canvas' });
    this.layer = new CellLayer(document.getElementById('dots'), this.columns, this.rows);
    this.hover = new Hover(document.getElementById('hover'), document.getElementById('ring'));
    this.legend = new Legend(document.getElementById('legend'), theme, [], () => { this.drawLoci(); this.colour(); });
    this.orbitPanel = new OrbitPanel(view, theme, () => window.dispatchEvent(new Event('resize')), () => this.mark(null));
    this.panel = this.orbitPanel.panel;
    this.zoom = new ZoomTools(this.chart, this.root);
    this.labels = new LabelTool(view.loci?.special.length > 0, () => this.drawLoci());
    this.export = new ExportTools({
      theme, chart: this.chart, legend: this.legend, under: this.layer.canvas, bar: () => this.bar(), table: () => this.table(),
    });
    document.getElementById('hint').textContent = `wheel: zoom · shift + wheel: zoom upright · drag: move${this.cells ? ' · click: the cell' : ''}`;
    document.getElementById('observables').hidden = this.quantities.length < 2;
    this.fillQuantities();
    this.fillLegend();
    this.draw();
    this.colour();
    this.listen();
  }

  // The kinds of cells where they have the colours, and the loci.
  fillLegend() {
    const kinds = this.cells && this.shown === this.kinds ? this.cells.entries : [];
    this.legend.entries = [...kinds.map(({ name, colour }, i) => ({
      type: String(i), title: name, swatch: (theme) => cellSwatch(theme.shade(colour)),
    })), ...lociEntries(this.view)];
    this.legend.root.hidden = this.legend.entries.length === 0;
    this.legend.draw();
  }

  loci() { return lociSeries(this.view, (type) => this.legend.shows(type), this.theme, this.labels.on); }

  drawLoci() { this.chart.setOption({ series: this.loci() }); }

  fillQuantities() {
    const select = document.getElementById('observable');
    for (const { key, name } of this.quantities) select.add(new Option(name, key));
    select.value = this.shown.key;
    select.addEventListener('change', () => {
      this.shown = this.quantities.find(({ key }) => key === select.value);
      this.hover.hide();
      this.fillLegend();
      this.colour();
    });
  }

  listen() {
    this.theme.onChange(() => { this.legend.draw(); this.draw(); this.colour(); });
    new ResizeObserver(() => { this.chart.resize(); this.draw(); }).observe(document.getElementById('stage'));
    this.chart.on('datazoom', () => { this.hover.hide(); this.drawCells(); });
    const zr = this.chart.getZr();
    zr.on('mousemove', (event) => {
      const cell = this.cellAt(event.offsetX, event.offsetY);
      zr.setCursorStyle(cell === null ? 'default' : 'pointer');
      const found = nearestOfLoci(this.view, (type) => this.legend.shows(type), this.plane, [event.offsetX, event.offsetY], kReach);
      if (found) this.showLocus(found);
      else if (cell === null) this.hover.hide();
      else this.show(cell);
    });
    zr.on('globalout', () => this.hover.hide());
    zr.on('click', (event) => {
      const cell = this.cellAt(event.offsetX, event.offsetY);
      if (cell !== null) this.open(cell);
    });
    this.root.addEventListener('keydown', (event) => this.key(event));
  }

  draw() {
    const { colours } = this.theme;
    const { x, y } = this.view;
    const [low, high] = [x.low, x.high].map((value) => x.factor * value);
    const none = { splitLine: { show: false } };
    const across = [axis(colours, axisName(x), low, high, { ...none, nameGap: 30 })];
    if (x.hertz) across.push(hertzAxis(colours, low, high));
    // No deeper than two cells.
    const zoom = (id, axes, cells) => ({ id, type: 'inside', ...axes, filterMode: 'none', minSpan: cells > 0 ? Math.min(100, 200 / cells) : 1e-6 });
    const option = {
      ...kCommon, grid: { left: 76, right: 22, top: x.hertz ? 52 : 16, bottom: 52 }, xAxis: across,
      yAxis: axis(colours, axisName(y), y.factor * y.low, y.factor * y.high, { ...none, nameGap: 54 }),
      series: [...this.loci(), {
        id: 'chosen', type: 'scatter', data: this.chosenData(), silent: true, symbol: 'rect', symbolSize: 11, z: 20,
        itemStyle: { color: 'transparent', borderColor: colours.ink, borderWidth: 2.5, opacity: 1, shadowColor: colours.paper, shadowBlur: 3 },
      }],
      dataZoom: [
        zoom('across', { xAxisIndex: across.map((_, i) => i) }, this.columns.count),
        { ...zoom('upright', { yAxisIndex: [0] }, this.rows.count), zoomOnMouseWheel: 'shift' },
      ],
    };
    keepZoom(this.chart, option);
    this.chart.setOption(option, { notMerge: true });
    this.hover.hide();
    this.drawCells();
  }

  // Every cell its colour, and the legend or the bar that tells of it.
  colour() {
    if (!this.cells) return;
    const { kind, kinds, entries } = this.cells;
    const bar = document.getElementById('bar');
    bar.hidden = this.shown === this.kinds;
    if (this.shown === this.kinds) {
      const pixels = kinds.map(({ entry }) => (this.legend.shows(String(entry)) ? pixelOf(this.theme.shade(entries[entry].colour)) : 0));
      this.layer.paint((cell) => pixels[kind[cell]] ?? 0);
    } else {
      const none = this.theme.shade(this.view.looks.none);
      const pixel = pixelScale(this.shown, pixelOf(none));
      const { values } = this.shown;
      // What is clear of the stops is blank, as in the pictures.
      const clear = kinds.map(({ name }) => name.startsWith('clear'));
      const isBlank = (cell) => clear[kind[cell]] && !Number.isFinite(values[cell]);
      const without = [];
      if (kind.some((_, cell) => isBlank(cell))) without.push(['clear of the stops (blank)', this.theme.colours.paper]);
      if (kind.some((at, cell) => kinds[at] && !clear[at] && !Number.isFinite(values[cell]))) without.push(['no number', none]);
      this.layer.paint((cell) => (kinds[kind[cell]] && !isBlank(cell) ? pixel(values[cell]) : 0));
      fillBar(bar, this.shown, without);
    }
    this.drawCells();
  }

  drawCells() {
    const { x, y } = this.view;
    this.plane = planeInView(this.chart, x.factor, y.factor);
    if (this.cells) this.layer.draw(this.plane);
    const range = (quantity, [low, high]) => `${quantity.name} from ${measure(quantity, low)} to ${measure(quantity, high)}`;
    this.root.setAttribute('aria-label', `Map of the ${this.shown.name} over ${range(x, this.plane.x)} and ` +
      `${range(y, this.plane.y)}.${this.cells ? ' Arrow keys go from cell to cell, Enter opens one.' : ''}`);
  }

  // For the image of the picture.
  bar() {
    if (this.shown === this.kinds) return null;
    return { name: axisName(this.shown), colours: this.shown.colours, tics: barTics(this.shown) };
  }

  table() {
    return mapTable(this.view, this.shown === this.kinds ? null : this.shown, (cell) => this.valuesAt(cell), this.plane, (type) => this.legend.shows(type));
  }

  cellAt(px, py) {
    const { left, right, top, bottom, x, y } = this.plane;
    if (!this.cells) return null;
    if (px < left || px > right || py < top || py > bottom) return null;
    const column = this.columns.placeOf(x[0] + ((px - left) / (right - left)) * (x[1] - x[0]));
    const row = this.rows.placeOf(y[1] - ((py - top) / (bottom - top)) * (y[1] - y[0]));
    if (column < 0 || column >= this.columns.count || row < 0 || row >= this.rows.count) return null;
    return this.rows.index(row) * this.columns.count + this.columns.index(column);
  }

  valuesAt(cell) {
    const column = cell % this.columns.count;
    return [this.view.x.values[column], this.view.y.values[(cell - column) / this.columns.count]];
  }

  kindName(cell) { return this.cells.kinds[this.cells.kind[cell]]?.name ?? 'not run'; }

  // Names and values of a cell.
  numbersOf(cell, digits) {
    const { x, y, numbers } = this.view;
    const values = this.valuesAt(cell);
    const told = (quantity) => {
      const value = quantity.values[cell];
      return [quantity.name, value === -Infinity ? '−∞' : Number.isFinite(value) ? measure(quantity, value, digits) : '–'];
    };
    return [[x.name, measure(x, values[0], 7)], [y.name, measure(y, values[1], 7)], ...numbers.map(told)];
  }

  // Of a locus, or of a point of codimension two.
  showLocus({ title, x, y }) {
    const [left, top] = this.chart.convertToPixel({ gridIndex: 0 }, [this.view.x.factor * x, this.view.y.factor * y]);
    this.hover.show({ x: left, y: top }, title,
      [[this.view.x.name, measure(this.view.x, x, 7)], [this.view.y.name, measure(this.view.y, y, 7)]], '');
  }

  show(cell) {
    this.pointed = cell;
    const { x, y } = this.view;
    const values = this.valuesAt(cell);
    const [left, top] = this.chart.convertToPixel({ gridIndex: 0 }, [x.factor * values[0], y.factor * values[1]]);
    this.hover.show({ x: left, y: top }, this.kindName(cell), this.numbersOf(cell, 5), this.keptCell(cell) === null ? 'click: how to follow it' : 'click: what it does');
  }

  // The nearest cell of its kind whose motion the page keeps, by its place in the list of those;
  // null without any.
  keptCell(cell) {
    const { kind } = this.cells;
    const { motions } = this.view;
    const { count } = this.columns;
    let best = null, least = Infinity;
    for (let k = 0; k < (motions?.length ?? 0); ++k) {
      if (kind[motions[k]] !== kind[cell]) continue;
      const across = (motions[k] % count) - (cell % count);
      const upright = Math.floor(motions[k] / count) - Math.floor(cell / count);
      const distance = Math.hypot(across / count, upright / this.rows.count);
      if (distance < least) [least, best] = [distance, k];
    }
    return best;
  }

  open(cell) {
    this.show(cell);
    this.mark(cell);
    const kept = this.keptCell(cell);
    const orbit = kept === null ? null : this.orbits.get(kept);
    const opened = this.panel.open(this.kindName(cell), orbit ? this.orbitPanel.factsOf(orbit) : []);
    this.panel.tellNumbers(this.numbersOf(cell, 7));
    this.panel.tellRemark(...this.remarksOn(cell, kept === null ? cell : this.view.motions[kept]), orbit?.remark);
    this.panel.tellCommand(cellCommand(this.view, this.valuesAt(cell)));
    this.orbitPanel.show(orbit);
    if (opened) this.panel.focus();
  }

  // `shown`: the cell whose motion is.
  remarksOn(cell, shown) {
    const { messages, kinds, kind } = this.cells;
    const { x, y, samples } = this.view;
    const said = messages?.texts[messages.of[cell]];
    const wild = kinds[kind[cell]]?.wild;
    const remarks = [said ? `${said[0].toUpperCase()}${said.slice(1)}.` : ''];
    // Starts in one basin lead to one orbit.
    if (shown !== cell && (wild || !this.view.is_of_starts)) {
      const values = this.valuesAt(shown);
      remarks.push(`The page keeps not every motion; this one, at ${x.name} ${measure(x, values[0], 7)} and ${y.name} ${measure(y, values[1], 7)}, is the nearest of its kind.`);
    }
    if (wild) remarks.push(`The numbers are those of the last ${samples} forcing periods, and a run agrees with the map for as long as rounding leaves it.`);
    return remarks;
  }

  chosenData() {
    if (this.chosen === null || this.chosen === undefined) return [];
    const [x, y] = this.valuesAt(this.chosen);
    return [[this.view.x.factor * x, this.view.y.factor * y]];
  }

  mark(cell) {
    this.chosen = cell;
    this.chart.setOption({ series: [{ id: 'chosen', data: this.chosenData() }] });
  }

  // To the cell beside, as seen.
  key(event) {
    if (!this.cells) return;
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (step) {
      const { count } = this.columns;
      const from = this.pointed ?? this.rows.index(this.rows.count >> 1) * count + this.columns.index(count >> 1);
      const beside = (axis, at, by) => axis.index(Math.max(0, Math.min(axis.count - 1, axis.index(at) + by)));
      this.show(beside(this.rows, Math.floor(from / count), step[1]) * count + beside(this.columns, from % count, step[0]));
    } else if (event.key === 'Enter' && this.pointed !== undefined) {
      this.open(this.pointed);
    } else {
      return;
    }
    event.preventDefault();
  }
}
