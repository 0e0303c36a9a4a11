// The picture over a parameter, or of two other quantities: a sweep's dots, branches, special points.
// The pointer or the arrow keys choose a point, a click or Enter opens its orbit.
import { keepZoom, partInView, planeInView } from './axes_in_view.js';
import { AxisChoice } from './axis_choice.js';
import { diagramTable } from './diagram_csv.js';
import { DiagramGeometry } from './diagram_geometry.js';
import { diagramNames, diagramOption, diagramTics, stripsOf } from './diagram_option.js';
import { DotLayer } from './dot_layer.js';
import { init } from './echarts_parts.js';
import { ExportTools } from './export_tools.js';
import { measure } from './format.js';
import { Hover } from './hover.js';
import { LabelTool } from './label_tool.js';
import { diagramEntries, Legend } from './legend.js';
import { nearestDot, nearestMark, nearestNode } from './nearest.js';
import { specialTitle } from './special_title.js';
import { ZoomTools } from './zoom_tools.js';

const kReach = 14;  // px
const kStable = 3;  // kind of a line

export class DiagramView {
  // `openOrbit(index, value, title)` shows an orbit of the page.
  constructor(view, theme, openOrbit) {
    Object.assign(this, { view, theme, openOrbit });
    this.stage = document.getElementById('stage');
    this.root = document.getElementById('chart');
    this.chart = init(this.root, null, { renderer: 'canvas' });
    this.dots = new DotLayer(document.getElementById('dots'));
    this.hover = new Hover(document.getElementById('hover'), document.getElementById('ring'));
    this.legend = new Legend(document.getElementById('legend'), theme, [], () => this.draw());
    this.zoom = new ZoomTools(this.chart, this.root);
    this.labels = new LabelTool(view.special.length + view.branches.length > 0, () => this.draw());
    this.axes = new AxisChoice([...view.observables, view.parameter], { x: view.parameter, y: view.observables[0] }, () => this.drawAxes());
    this.export = new ExportTools({ theme, chart: this.chart, legend: this.legend, under: this.dots.canvas, table: () => this.table() });
    this.drawAxes();
    this.listen();
  }

  // Of what was chosen for the axes.
  drawAxes() {
    const { x, y } = this.axes.scales;
    this.geometry = new DiagramGeometry(this.view, x, y);
    this.ranges = { x: this.geometry.range('x') ?? [0, 1], y: this.geometry.range('y') ?? [0, 1] };
    this.legend.entries = diagramEntries(this.view, this.geometry, stripsOf(this.view, x));
    this.legend.draw();
    this.chosen = null;
    if (this.chart.getOption()) this.zoom.whole();
    this.draw();
  }

  listen() {
    this.theme.onChange(() => { this.legend.draw(); this.draw(); });
    new ResizeObserver(() => { this.chart.resize(); this.draw(); }).observe(this.stage);
    this.chart.on('datazoom', () => this.zoomed());
    const zr = this.chart.getZr();
    zr.on('mousemove', (event) => this.point(event.offsetX, event.offsetY));
    zr.on('globalout', () => this.hover.hide());
    zr.on('click', (event) => {
      const found = this.nearest(event.offsetX, event.offsetY);
      if (found) this.open(found);
    });
    this.root.addEventListener('keydown', (event) => this.key(event));
  }

  shows(type) { return this.legend.shows(type); }

  // The part of the ranges that the zoom shows.
  inView(dataZoom) {
    const part = (id, range) => partInView(range, dataZoom.find((zoom) => zoom.id === id));
    return { x: part('across', this.ranges.x), y: part('upright', this.ranges.y) };
  }

  get picture() {
    const { view, geometry, ranges, theme } = this;
    return { view, geometry, ranges, theme, shows: (type) => this.shows(type), labels: this.labels.on };
  }

  draw() {
    const kept = this.chart.getOption()?.dataZoom;
    const inView = kept ? this.inView(kept) : this.ranges;
    const option = diagramOption(this.picture, inView, this.root.clientHeight);
    keepZoom(this.chart, option);
    const tics = diagramTics(this.view, this.geometry, inView);
    for (const name of ['xAxis', 'yAxis'])
      tics[name].forEach((more, i) => {
        const axis = option[name][i];
        Object.assign(axis, { ...more, axisTick: { ...axis.axisTick, ...more.axisTick }, axisLabel: { ...axis.axisLabel, ...more.axisLabel } });
      });
    this.chart.setOption(option, { notMerge: true });
    this.hover.hide();
    this.drawDots();
  }

  // ECharts takes no option while it tells of a zoom.
  zoomed() {
    this.hover.hide();
    this.drawDots();
    const { x, y } = this.geometry;
    const hasLog = x.kind === 'log' || y.kind === 'log';
    if (!hasLog && !this.labels.on) return;
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => {
      const inView = this.inView(this.chart.getOption().dataZoom);
      this.chart.setOption({ ...(hasLog ? diagramTics(this.view, this.geometry, inView) : {}), ...diagramNames(this.picture, inView) });
    });
  }

  drawDots() {
    this.plane = planeInView(this.chart);
    const { sweep, looks } = this.view;
    const { x, y, cloud } = this.geometry;
    const kinds = [looks.dots.periodic, looks.dots.wild];
    this.dots.draw(cloud, sweep?.wild, this.plane, kinds.map(({ id }) => this.shows(id)), kinds.map(({ colour }) => this.theme.shade(colour)));
    const range = (scale, [low, high]) => `${scale.measure(low)} to ${scale.measure(high)}`;
    this.root.setAttribute('aria-label',
      `${y.quantity.name} from ${range(y, this.plane.y)} over ${x.quantity.name} from ${range(x, this.plane.x)}. ` +
      'Arrow keys go from point to point, Enter opens the orbit.');
  }

  nearest(px, py) {
    const { plane, geometry } = this;
    if (px < plane.left - kReach || px > plane.right + kReach || py < plane.top - kReach || py > plane.bottom + kReach)
      return null;
    const perPixel = {
      x: (plane.x[1] - plane.x[0]) / (plane.right - plane.left),
      y: (plane.y[1] - plane.y[0]) / (plane.bottom - plane.top),
    };
    const place = { x: plane.x[0] + (px - plane.left) * perPixel.x, y: plane.y[1] - (py - plane.top) * perPixel.y };
    const mark = nearestMark(geometry.marks, place, perPixel, kReach, ({ special }) => this.shows(special.type));
    if (mark) return mark;  // there are few, and they lie on all else
    const node = nearestNode(geometry.lines, place, perPixel, kReach, ({ kind }) => this.shows(this.view.looks.lines[kind].id));
    const dot = geometry.cloud ? nearestDot(geometry.cloud, this.view.sweep.wild, place, perPixel, kReach, (type) => this.shows(type)) : null;
    if (node && dot) return node.distance <= dot.distance + 2 ? node : dot;
    return node ?? dot;
  }

  point(px, py) {
    const found = this.nearest(px, py);
    this.chart.getZr().setCursorStyle(found ? 'pointer' : 'default');
    if (found) this.show(found);
    else this.hover.hide();
  }

  show(found) {
    this.chosen = found;
    const [x, y] = this.chart.convertToPixel({ gridIndex: 0 }, [found.x, found.y]);
    this.hover.show({ x, y }, this.titleOf(found), this.valuesOf(found), this.orbitOf(found) === null ? '' : 'click: the orbit');
  }

  titleOf(found) {
    if (found.kind === 'special') return specialTitle(this.view, found.special);
    if (found.kind === 'dot') return `sweep: ${this.view.sweep.labels[this.view.sweep.label[found.row]]}`;
    const branch = this.view.branches[found.line.branch];
    return `branch ${branch.id}, ${branch.name}: ${this.view.looks.lines[found.line.kind].title}`;
  }

  // SI.
  valueOf(quantity, found) {
    if (found.kind === 'dot') return this.geometry.dotValue(quantity, found.row, found.dot);
    if (found.kind === 'special') return this.geometry.valueAt(quantity, 0, -1 - this.view.special.indexOf(found.special), found.index);
    return this.geometry.valueAt(quantity, found.line.branch, found.line.point[found.node], found.line.index?.[found.node] ?? 0);
  }

  valuesOf(found) {
    const { parameter, sweep, observables, stops } = this.view;
    const { x, y, counted } = this.geometry;
    const shown = new Set([parameter, y.quantity, x.quantity]);
    // All that a dot has; where it is no single impact, of the motion.
    if (found.kind === 'dot')
      for (const quantity of observables)
        if (sweep.dots[quantity.key] && (counted || quantity.of_motion)) shown.add(quantity);
    const values = [];
    for (const quantity of shown) {
      const value = this.valueOf(quantity, found);
      if (Number.isFinite(value)) values.push([quantity.name, measure(quantity, value, quantity === parameter ? 7 : 5)]);
    }
    if (found.kind === 'special') return [...values, ...found.special.more];
    if (found.kind === 'dot' && counted && sweep.stop && stops > 1) values.push(['at stop', String(sweep.stop[found.dot])]);
    if (found.kind === 'point' && found.line.point[found.node] >= 0)
      values.push(['multipliers outside the circle', String(this.view.branches[found.line.branch].unstable[found.line.point[found.node]])]);
    return values;
  }

  // The special point that is found, or null.
  specialOf(found) {
    if (found.kind === 'special') return found.special;
    if (found.kind === 'point' && found.line.point[found.node] < 0) return this.view.special[-1 - found.line.point[found.node]];
    return null;
  }

  // The orbit that the page has of it, or the nearest on its branch; null where there is none.
  orbitOf(found) {
    const valid = (index) => (index >= 0 ? index : null);
    const special = this.specialOf(found);
    if (special) return valid(special.orbit);
    const { sweep, branches } = this.view;
    if (found.kind === 'dot')
      return valid(nearestKept(sweep.orbit, found.row, (row) => sweep.label[row] === sweep.label[found.row]));
    return valid(nearestKept(branches[found.line.branch].orbit, found.line.point[found.node], () => true));
  }

  open(found) {
    const orbit = this.orbitOf(found);
    const special = this.specialOf(found);
    this.show(found);
    if (orbit !== null) this.openOrbit(orbit, this.valueOf(this.view.parameter, found), special && specialTitle(this.view, special));
  }

  key(event) {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step) this.step(step);
    else if (event.key === 'Enter' && this.chosen) this.open(this.chosen);
    else return;
    event.preventDefault();
  }

  // To the next point of the line, the next row of the sweep, or the first point of all.
  step(by) {
    const { lines, cloud } = this.geometry;
    const last = this.chosen;
    if (last?.kind === 'point' && lines.includes(last.line)) return this.showNode(last.line, last.node, by);
    if (last?.kind === 'dot' && cloud) {
      const { values } = this.view.sweep;
      return this.showRow(last.row, values[0] <= values[values.length - 1] ? by : -by);
    }
    const line = lines.find((part) => part.kind === kStable) ?? lines[0];
    if (line) return this.showNode(line, -1, 1);
    return cloud ? this.showRow(-1, 1) : undefined;
  }

  // The next node or row that is somewhere.
  showNode(line, from, by) {
    for (let node = from + by; node >= 0 && node < line.x.length; node += by)
      if (Number.isFinite(line.x[node]) && Number.isFinite(line.y[node]))
        return this.show({ kind: 'point', line, node, x: line.x[node], y: line.y[node] });
    return undefined;
  }

  showRow(from, by) {
    const { cloud } = this.geometry;
    const rows = this.view.sweep.values.length;
    for (let row = from + by; row >= 0 && row < rows; row += by) {
      const at = cloud.row.indexOf(row);
      if (at >= 0 && Number.isFinite(cloud.x[at]) && Number.isFinite(cloud.y[at]))
        return this.show({ kind: 'dot', row, dot: cloud.dot[at], x: cloud.x[at], y: cloud.y[at] });
    }
    return undefined;
  }

  table() { return diagramTable(this.view, this.geometry, this.plane, (type) => this.shows(type)); }
}

// The entry of `orbits` at `from`, or the nearest one that is kept and `alike`; -1 where none is.
function nearestKept(orbits, from, alike) {
  for (let away = 0; away < orbits.length; ++away)
    for (const at of [from - away, from + away])
      if (at >= 0 && at < orbits.length && orbits[at] >= 0 && alike(at)) return orbits[at];
  return -1;
}
