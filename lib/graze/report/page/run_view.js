// A motion over time: displacement, velocity, forces, energy. The pointer or the arrow keys choose a
// moment, a click or Enter keeps it; beside it stands the phase portrait of what is in view.
import { keepZoom } from './axes_in_view.js';
import { BeamFigure } from './beam_figure.js';
import { CsvTable, digits } from './csv_table.js';
import { init } from './echarts_parts.js';
import { ExportTools } from './export_tools.js';
import { axisName, measure } from './format.js';
import { Hover } from './hover.js';
import { Legend } from './legend.js';
import { cellSwatch, lookSwatch } from './marks.js';
import { RunPanel } from './run_panel.js';
import { impactsWithin, marksDependOnView, runHeight, runMarks, runOption } from './run_option.js';
import { ZoomTools } from './zoom_tools.js';

const kReach = 10;  // px
const kRest = 40;   // ms

// The index of the last of sorted times up to `time`, -1 where there is none.
function lastUpTo(times, time) {
  let from = 0, to = times.length;
  while (from < to) {
    const middle = (from + to) >> 1;
    if (times[middle] <= time) from = middle + 1;
    else to = middle;
  }
  return from - 1;
}

// The index of the sample nearest to a time within a piece of the curve; null where it has a gap.
function nearestSample(times, values, time) {
  const at = lastUpTo(times, time);
  if (times[at] === time && Number.isFinite(values[at])) return at;
  if (!Number.isFinite(values[at]) || !Number.isFinite(values[at + 1])) return null;
  return time - times[at] < times[at + 1] - time ? at : at + 1;
}

export class RunView {
  constructor(view, theme) {
    Object.assign(this, { view, theme });
    this.window = [view.time.low, view.time.high];
    this.stage = document.getElementById('stage');
    this.root = document.getElementById('chart');
    this.cursor = document.getElementById('cursor');
    document.getElementById('observables').hidden = true;
    document.getElementById('hint').textContent = 'wheel: zoom in time · drag: move · click: keep the moment';
    this.stage.style.height = `max(${runHeight(view)}px, min(68vh, 720px))`;
    this.chart = init(this.root, null, { renderer: 'canvas' });
    this.hover = new Hover(document.getElementById('hover'), document.getElementById('ring'));
    this.legend = new Legend(document.getElementById('legend'), theme, this.entries(), () => this.draw());
    this.zoom = new ZoomTools(this.chart, this.root);
    this.panel = new RunPanel(view, theme);
    if (view.beam) this.beam = new BeamFigure(document.getElementById('beam'), view, theme);
    this.export = new ExportTools({ theme, chart: this.chart, legend: this.legend, table: () => this.table() });
    this.draw();
    this.listen();
  }

  entries() {
    const { view } = this;
    const entries = [];
    if (view.places.some((place) => place.impacts.t.length > 0))
      entries.push({ type: 'impacts', title: 'impact', swatch: (theme) => lookSwatch({ mark: 'dot', colour: view.looks.impact, size: 0.6 }, theme) });
    if (view.places.some((place) => place.stuck.length > 0))
      entries.push({ type: 'stuck', title: 'stuck', swatch: (theme) => cellSwatch(theme.shade(view.looks.stuck)) });
    view.panels.forEach((panel, i) => {
      if (panel.curves?.length > 1)
        panel.curves.forEach((curve, k) => entries.push({
          type: `${i} ${k}`, title: curve.name,
          swatch: (theme) => lookSwatch({ mark: 'none', colour: curve.colour, width: 1.8, dashes: [] }, theme),
        }));
    });
    return entries;
  }

  listen() {
    this.theme.onChange(() => { this.legend.draw(); this.draw(); });
    new ResizeObserver(() => this.resize()).observe(this.stage);
    this.chart.on('datazoom', () => this.zoomed());
    const zr = this.chart.getZr();
    zr.on('mousemove', (event) => {
      const moment = this.momentAt(event.offsetX, event.offsetY);
      if (moment) this.show(moment);
      else this.hideMoment();
    });
    zr.on('globalout', () => this.hideMoment());
    zr.on('click', (event) => {
      const moment = this.momentAt(event.offsetX, event.offsetY);
      if (moment) this.keep(moment);
    });
    this.root.addEventListener('keydown', (event) => this.key(event));
  }

  resize() {
    const { clientWidth, clientHeight } = this.root;
    if (this.chart.getWidth() === clientWidth && this.chart.getHeight() === clientHeight) return;
    this.chart.resize();
    this.draw();
  }

  shows(type) { return this.legend.shows(type); }

  draw() {
    const option = runOption(this.view, (type) => this.shows(type), this.theme, this.root.clientHeight);
    for (const mark of this.marks()) Object.assign(option.series.find(({ id }) => id === mark.id), mark);
    keepZoom(this.chart, option);
    this.chart.setOption(option, { notMerge: true });
    this.hideMoment();
    this.tellWindow();
  }

  box(i) { return this.chart.getModel().getComponent('grid', i).coordinateSystem.getRect(); }

  // What takes long waits until the wheel rests; and ECharts takes no option while it tells of a zoom.
  zoomed() {
    this.hideMoment();
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => {
      this.tellWindow();
      if (marksDependOnView(this.view)) this.chart.setOption({ series: this.marks() });
    }, kRest);
  }

  // What is in view: for the marks, the portrait, and those who do not see it.
  tellWindow() {
    const { time, panels } = this.view;
    const { x, width } = this.box(0);
    this.window = [x, x + width].map((px) => this.chart.convertFromPixel({ xAxisIndex: 0 }, px) / time.factor);
    this.panel.look(this.window);
    this.beam?.look(this.window);
    this.root.setAttribute('aria-label', `Motion from ${measure(time, this.window[0])} to ${measure(time, this.window[1])}: ` +
      `${panels.map((panel) => panel.name).join(', ')}. Arrow keys go from impact to impact, Enter keeps the moment.`);
  }

  marks() {
    const window = marksDependOnView(this.view) ? this.window : [-Infinity, Infinity];
    return runMarks(this.view, (type) => this.shows(type), window);
  }

  // The moment under the pointer, and the panel that it is in; the impact where one is within reach.
  momentAt(px, py) {
    const { panels, places, time } = this.view;
    const i = panels.findIndex((_, k) => {
      const { x, y, width, height } = this.box(k);
      return px >= x && px <= x + width && py >= y && py <= y + height;
    });
    if (i < 0) return null;
    const [at, beside] = [px, px + kReach].map((x) => this.chart.convertFromPixel({ xAxisIndex: 0 }, x) / time.factor);
    const place = panels[i].place ?? 0;
    const { t } = places[place].impacts;
    const next = [lastUpTo(t, at), lastUpTo(t, at) + 1].filter((k) => k >= 0 && k < t.length && Math.abs(t[k] - at) <= beside - at)
      .sort((a, b) => Math.abs(t[a] - at) - Math.abs(t[b] - at))[0];
    return next === undefined || !this.shows('impacts') ? { panel: i, place, time: at } : { panel: i, place, time: t[next], impact: next };
  }

  // What a panel shows: names, times, SI values.
  curvesOf(i) {
    const panel = this.view.panels[i];
    if (panel.curves) return panel.curves.map((curve) => ({ ...curve, name: panel.curves.length > 1 ? curve.name : panel.name }));
    const { t, x, v } = this.view.places[panel.place];
    return [{ name: panel.more ? `${panel.name} ${panel.more}` : panel.name, t, y: panel.kind === 'displacement' ? x : v }];
  }

  // The curves and impacts in view. What several curves have at one time stands in one row, and where a
  // curve jumps there are two.
  table() {
    const { time, panels, places } = this.view;
    const [low, high] = this.window;
    const rows = new Map();
    const columns = [axisName(time)];
    const add = (t, again, column, value) => {
      const key = `${t} ${again}`;
      if (!rows.has(key)) rows.set(key, { t, again, cells: [] });
      rows.get(key).cells.push([column, digits(value, 8)]);
    };
    panels.forEach((panel, i) => this.curvesOf(i).forEach(({ name, t, y }, k) => {
      if (panel.curves?.length > 1 && !this.shows(`${i} ${k}`)) return;
      const column = axisName({ name, unit: panel.unit });
      columns.push(column);
      for (let n = 0, again = 0; n < t.length; ++n) {
        if (!(t[n] >= low && t[n] <= high) || !Number.isFinite(y[n])) continue;
        again = n > 0 && t[n] === t[n - 1] ? again + 1 : 0;
        add(t[n], again, column, panel.factor * y[n]);
      }
    }));
    if (this.shows('impacts')) places.forEach((place) => {
      const names = ['before', 'after'].map((when) => axisName({ name: `velocity ${when} the impact${place.name ? ` at ${place.name}` : ''}`, unit: this.view.speed.unit }));
      for (const k of impactsWithin(place.impacts, this.window))
        ['before', 'after'].forEach((when, n) => add(place.impacts.t[k], 0, names[n], this.view.speed.factor * place.impacts[when][k]));
      if (place.impacts.t.length > 0) columns.push(...names);
    });
    const table = new CsvTable(columns);
    for (const { t, cells } of [...rows.values()].sort((a, b) => a.t - b.t || a.again - b.again))
      table.row([columns[0], digits(time.factor * t)], ...cells);
    return table;
  }

  // Names and values at a moment.
  valuesAt({ time, place, impact }, digits) {
    const { view } = this;
    const rows = [];
    if (impact !== undefined) {
      const { before, after } = view.places[place].impacts;
      rows.push(['velocity before', measure(view.speed, before[impact], digits)], ['velocity after', measure(view.speed, after[impact], digits)]);
    }
    view.panels.forEach((panel, i) => {
      if (panel.kind === 'velocity' && impact !== undefined && panel.place === place) return;  // it jumps
      for (const { name, t, y } of this.curvesOf(i)) {
        const at = nearestSample(t, y, time);
        if (at !== null) rows.push([name, measure(panel, y[at], digits)]);
      }
    });
    return rows;
  }

  titleOf({ time, place, impact }) {
    const when = measure(this.view.time, time, 7);
    if (impact === undefined) return when;
    return `${when}: impact${this.view.places.length > 1 || this.view.places[0].stops.length > 1 ? ` on stop ${this.panel.stopOf(place, impact)}` : ''}`;
  }

  show(moment) {
    this.moment = moment;
    const { view } = this;
    const panel = view.panels[moment.panel];
    const [source] = this.curvesOf(moment.panel);
    const at = nearestSample(source.t, source.y, moment.time);
    const x = this.chart.convertToPixel({ xAxisIndex: 0 }, view.time.factor * moment.time);
    const { y: top, height } = this.box(moment.panel);
    const y = at === null ? top + height / 2 : this.chart.convertToPixel({ yAxisIndex: moment.panel }, panel.factor * source.y[at]);
    this.hover.show({ x, y }, this.titleOf(moment), this.valuesAt(moment, 5), 'click: keep the moment');
    this.hover.ring.hidden = at === null;
    const end = this.box(view.panels.length - 1);
    Object.assign(this.cursor.style, { left: `${x}px`, top: `${this.box(0).y}px`, height: `${end.y + end.height - this.box(0).y}px` });
    this.cursor.hidden = false;
    this.panel.point(moment.time);
    this.beam?.showTime(moment.time);
  }

  hideMoment() {
    this.hover.hide();
    this.cursor.hidden = true;
    this.panel.point(null);
  }

  keep(moment) {
    this.show(moment);
    this.panel.keep(moment.time, [['at', this.titleOf(moment)], ...this.valuesAt(moment, 7)]);
  }

  key(event) {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step) {
      const { t } = this.view.places[0].impacts;
      const from = this.moment?.time ?? this.window[0];
      const next = step > 0 ? lastUpTo(t, from) + 1 : lastUpTo(t, from - 1e-12 * Math.abs(from));
      if (next >= 0 && next < t.length && t[next] >= this.window[0] && t[next] <= this.window[1])
        this.show({ panel: 0, place: 0, time: t[next], impact: next });
    } else if (event.key === 'Enter' && this.moment) {
      this.keep(this.moment);
    } else {
      return;
    }
    event.preventDefault();
  }
}
