// The picture over a parameter: a sweep's dots, branches, special points. The pointer or the arrow
// keys choose a point, a click or Enter opens its orbit.
import { keepZoom, planeInView } from './axes_in_view.js';
import { diagramOption } from './diagram_option.js';
import { DotLayer } from './dot_layer.js';
import { init } from './echarts_parts.js';
import { measure } from './format.js';
import { Hover } from './hover.js';
import { diagramEntries, Legend } from './legend.js';
import { kLineKinds, markOf } from './marks.js';
import { nearestDot, nearestNode, nearestSpecial } from './nearest.js';
import { ZoomTools } from './zoom_tools.js';

const kReach = 14;  // px

export class DiagramView {
  // `openOrbit(index, value)` shows an orbit of the page.
  constructor(view, theme, openOrbit) {
    Object.assign(this, { view, theme, openOrbit });
    this.shown = view.observables[0];
    this.stage = document.getElementById('stage');
    this.root = document.getElementById('chart');
    this.chart = init(this.root, null, { renderer: 'canvas' });
    this.dots = new DotLayer(document.getElementById('dots'));
    this.hover = new Hover(document.getElementById('hover'), document.getElementById('ring'));
    this.legend = new Legend(document.getElementById('legend'), theme, diagramEntries(view), () => this.draw());
    this.zoom = new ZoomTools(this.chart, this.root);
    this.fillObservables();
    this.draw();
    this.listen();
  }

  fillObservables() {
    const select = document.getElementById('observable');
    for (const observable of this.view.observables) select.add(new Option(observable.name, observable.key));
    select.addEventListener('change', () => {
      this.shown = this.view.observables.find((observable) => observable.key === select.value);
      this.chosen = null;
      this.zoom.whole();
      this.draw();
    });
    document.getElementById('observables').hidden = this.view.observables.length < 2;
  }

  listen() {
    this.theme.onChange(() => { this.legend.draw(); this.draw(); });
    new ResizeObserver(() => { this.chart.resize(); this.draw(); }).observe(this.stage);
    this.chart.on('datazoom', () => { this.hover.hide(); this.drawDots(); });
    const zr = this.chart.getZr();
    zr.on('mousemove', (event) => this.point(event.offsetX, event.offsetY));
    zr.on('globalout', () => this.hover.hide());
    zr.on('click', (event) => {
      const found = this.nearest(event.offsetX, event.offsetY);
      if (found) this.open(found);
    });
    this.root.addEventListener('keydown', (event) => this.key(event));
  }

  draw() {
    const shows = (type) => this.legend.shows(type);
    const option = diagramOption(this.view, this.shown, shows, this.theme.colours, this.root.clientHeight);
    keepZoom(this.chart, option);
    this.chart.setOption(option, { notMerge: true });
    this.hover.hide();
    this.drawDots();
  }

  plane() {
    return planeInView(this.chart, this.view.parameter.factor, this.shown.factor);
  }

  drawDots() {
    const plane = this.plane();
    const { sweep, parameter } = this.view;
    const shown = [this.legend.shows('periodic'), this.legend.shows('wild')];
    if (sweep) this.dots.draw(sweep, sweep.dots[this.shown.key], plane, shown, this.theme.colours);
    const range = (quantity, [low, high]) => `${measure(quantity, low)} to ${measure(quantity, high)}`;
    this.root.setAttribute('aria-label',
      `${this.shown.name} from ${range(this.shown, plane.y)} over ${parameter.name} from ` +
      `${range(parameter, plane.x)}. Arrow keys go from point to point, Enter opens the orbit.`);
  }

  nearest(px, py) {
    const plane = this.plane();
    if (px < plane.left - kReach || px > plane.right + kReach || py < plane.top - kReach || py > plane.bottom + kReach)
      return null;
    const perPixel = {
      x: (plane.x[1] - plane.x[0]) / (plane.right - plane.left),
      y: (plane.y[1] - plane.y[0]) / (plane.bottom - plane.top),
    };
    const place = { x: plane.x[0] + (px - plane.left) * perPixel.x, y: plane.y[1] - (py - plane.top) * perPixel.y };
    const { sweep, lines, special } = this.view;
    const { key } = this.shown;
    const shows = (type) => this.legend.shows(type);
    const mark = nearestSpecial(special, key, place, perPixel, kReach, shows);
    if (mark) return mark;  // there are few, and they lie on all else
    const node = nearestNode(lines[key] ?? [], place, perPixel, kReach, (kind) => shows(kLineKinds[kind].type));
    const dot = sweep?.dots[key] ? nearestDot(sweep, sweep.dots[key], place, perPixel, kReach, shows) : null;
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
    const [x, y] = this.chart.convertToPixel({ gridIndex: 0 },
      [this.view.parameter.factor * found.value, this.shown.factor * found.height]);
    const values = [[this.view.parameter.name, measure(this.view.parameter, found.value, 7)]];
    this.hover.show({ x, y }, this.titleOf(found), [...values, ...this.valuesOf(found)],
      this.orbitOf(found) === null ? '' : 'click: the orbit');
  }

  titleOf(found) {
    if (found.kind === 'special') return `${found.special.id}: ${markOf(found.special.label).title}`;
    if (found.kind === 'dot') return `sweep: ${this.view.sweep.labels[this.view.sweep.label[found.row]]}`;
    const branch = this.view.branches[found.line.branch];
    return `branch ${branch.id}, ${branch.name}: ${kLineKinds[found.line.kind].title}`;
  }

  valuesOf(found) {
    if (found.kind === 'special') {
      const shown = [this.shown.name, measure(this.shown, found.height)];
      return [shown, ...found.special.more];
    }
    const values = [];
    if (found.kind === 'dot') {
      const { sweep } = this.view;
      for (const observable of this.view.observables)
        if (sweep.dots[observable.key]) values.push([observable.name, measure(observable, sweep.dots[observable.key][found.dot])]);
      if (sweep.stop && this.view.stops > 1) values.push(['at stop', String(sweep.stop[found.dot])]);
      return values;
    }
    values.push([this.shown.name, measure(this.shown, found.height)]);
    const unstable = this.pointOf(found) === null ? null
      : this.view.branches[found.line.branch].unstable[this.pointOf(found)];
    if (unstable !== null) values.push(['multipliers outside the circle', String(unstable)]);
    return values;
  }

  // The index of a node's point in its branch; null on a special point, which lies between two.
  pointOf(found) {
    const point = found.line.point[found.node];
    return point < 0 ? null : point;
  }

  // The orbit that the page has of it, or the nearest on its branch; null where there is none.
  orbitOf(found) {
    const valid = (index) => (index >= 0 ? index : null);
    if (found.kind === 'special') return valid(found.special.orbit);
    if (found.kind === 'dot') return valid(nearestKept(this.view.sweep.orbit, found.row,
      (row) => this.view.sweep.label[row] === this.view.sweep.label[found.row]));
    const point = found.line.point[found.node];
    if (point < 0) return valid(this.view.special[-1 - point].orbit);
    return valid(nearestKept(this.view.branches[found.line.branch].orbit, point, () => true));
  }

  open(found) {
    const orbit = this.orbitOf(found);
    this.show(found);
    if (orbit !== null) this.openOrbit(orbit, found.value);
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
    const { sweep, lines } = this.view;
    const { key } = this.shown;
    const last = this.chosen;
    if (last?.kind === 'point' && lines[key]?.includes(last.line)) {
      const node = Math.max(0, Math.min(last.line.x.length - 1, last.node + by));
      return this.show({ ...last, node, value: last.line.x[node], height: last.line.y[node] });
    }
    if (last?.kind === 'dot' && sweep?.dots[key]) {
      let row = last.row;
      const up = sweep.values[0] <= sweep.values[sweep.values.length - 1] ? by : -by;
      do row += up; while (row >= 0 && row < sweep.values.length && sweep.first[row] === sweep.first[row + 1]);
      if (row < 0 || row >= sweep.values.length) return undefined;
      const dot = sweep.first[row];
      return this.show({ kind: 'dot', row, dot, value: sweep.values[row], height: sweep.dots[key][dot] });
    }
    const line = lines[key]?.find((part) => part.kind === 3) ?? lines[key]?.[0];
    if (line) return this.show({ kind: 'point', line, node: 0, value: line.x[0], height: line.y[0] });
    if (!sweep?.dots[key]?.length) return undefined;
    const row = sweep.first.findIndex((at) => at > 0) - 1;
    return this.show({ kind: 'dot', row, dot: 0, value: sweep.values[row], height: sweep.dots[key][0] });
  }
}

// The entry of `orbits` at `from`, or the nearest one that is kept and `alike`; -1 where none is.
function nearestKept(orbits, from, alike) {
  for (let away = 0; away < orbits.length; ++away)
    for (const at of [from - away, from + away])
      if (at >= 0 && at < orbits.length && orbits[at] >= 0 && alike(at)) return orbits[at];
  return -1;
}
