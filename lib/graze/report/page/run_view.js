// The chart of a motion over time. The pointer chooses a moment, of which all panels tell, the arrow keys an
// impact, a click or Enter keeps it; beside it stands the phase portrait of what is in view.
import { BeamFigure } from './beam_figure.js';
import { kJumps } from './charts_option.js';
import { ChartsView, plain } from './charts_view.js';
import { CsvTable, digits } from './csv_table.js';
import { axisName, measure } from './format.js';
import { impactsWithin, RunPanel } from './run_panel.js';

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
function nearestSample({ x: times, y: values }, time) {
  const at = lastUpTo(times, time);
  if (times[at] === time && Number.isFinite(values[at])) return at;
  if (!Number.isFinite(values[at]) || !Number.isFinite(values[at + 1])) return null;
  return time - times[at] < times[at + 1] - time ? at : at + 1;
}

export class RunView extends ChartsView {
  constructor(view, theme) {
    super(view, null, theme);
    this.cursor = document.getElementById('cursor');
    document.getElementById('hint').textContent = 'wheel: zoom in time · shift + wheel: zoom upright · drag: move · click: keep the moment';
    this.panel = new RunPanel(view, this.drawn, theme);
    this.places = this.panel.runPlaces;
    if (view.beam) this.beam = new BeamFigure(document.getElementById('beam'), { beam: view.beam, time: this.time }, theme);
    this.look();
  }

  get time() { return this.drawn[0].panel.x; }
  get window() { return this.inView(0).x.map((at) => this.drawn[0].x.back(at)); }

  // What takes long waits until the wheel rests.
  drawInView() {
    super.drawInView();
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.look(), this.panel ? kRest : 0);
  }

  look() {
    this.panel.look(this.window);
    this.beam?.look(this.window);
  }

  // The moment under the pointer, and the panel that it is in; the impact where one is within reach.
  nearest(px, py) {
    const i = this.drawn.findIndex((_, k) => {
      const { left, right, top, bottom } = this.plane(k);
      return px >= left && px <= right && py >= top && py <= bottom;
    });
    if (i < 0) return null;
    const [at, beside] = [px, px + kReach].map((x) => this.chart.convertFromPixel({ xAxisIndex: 0 }, x) / this.time.factor);
    const place = i < this.places.length ? i : 0;
    const { t } = this.places[place].impacts;
    const next = [lastUpTo(t, at), lastUpTo(t, at) + 1].filter((k) => k >= 0 && k < t.length && Math.abs(t[k] - at) <= beside - at)
      .sort((a, b) => Math.abs(t[a] - at) - Math.abs(t[b] - at))[0];
    return next === undefined || !this.shows('impact') ? { panel: i, place, time: at } : { panel: i, place, time: t[next], impact: next };
  }

  orbitOf() { return -1; }

  // The curves of a panel, also those that are hidden: names, and series of SI values.
  curvesOf({ panel, lines }) {
    return lines.map(({ series }) => series).filter(({ line, look }) => line && look.id !== kJumps)
      .map((series, _, { length }) => ({ name: length > 1 ? series.title : plain(panel.y.name), series }));
  }

  // Names and values at a moment.
  momentOf({ time, place, impact }, count) {
    const rows = [];
    const velocity = this.drawn[this.places.length].panel;
    if (impact !== undefined) {
      const { before, after } = this.places[place].impacts;
      rows.push(['velocity before', measure(velocity.y, before[impact], count)], ['velocity after', measure(velocity.y, after[impact], count)]);
    }
    this.drawn.forEach((one, i) => {
      if (i === this.places.length && impact !== undefined && place === 0) return;  // it jumps
      for (const { name, series } of this.curvesOf(one)) {
        const at = nearestSample(series, time);
        if (at !== null) rows.push([name, measure(one.panel.y, series.y[at], count)]);
      }
    });
    return rows;
  }

  titleOf({ time, place, impact }) {
    const when = measure(this.time, time, 7);
    if (impact === undefined) return when;
    return `${when}: impact${this.places.length > 1 || this.places[0].stops.length > 1 ? ` on stop ${this.panel.stopOf(place, impact)}` : ''}`;
  }

  show(moment) {
    if (!this.panel) return;
    this.panel.point(moment?.time ?? null);
    this.cursor.hidden = moment === null;
    if (moment === null) return this.hover.hide();
    this.chosen = moment;
    const { panel: i, time } = moment;
    const [source] = this.curvesOf(this.drawn[i]);
    const at = source ? nearestSample(source.series, time) : null;
    const { top, bottom } = this.plane(i);
    const x = this.chart.convertToPixel({ xAxisIndex: 0 }, this.time.factor * time);
    const y = at === null ? (top + bottom) / 2 : this.chart.convertToPixel({ yAxisIndex: i }, this.drawn[i].y.of(source.series.y[at]));
    this.hover.show({ x, y }, this.titleOf(moment), this.momentOf(moment, 5), 'click: keep the moment');
    this.hover.ring.hidden = at === null;
    const from = this.plane(0).top, to = this.plane(this.drawn.length - 1).bottom;
    Object.assign(this.cursor.style, { left: `${x}px`, top: `${from}px`, height: `${to - from}px` });
    this.beam?.showTime(time);
  }

  open(moment) {
    this.show(moment);
    this.panel.keep(moment.time, [['at', this.titleOf(moment)], ...this.momentOf(moment, 7)]);
  }

  // From impact to impact at the first place.
  step(by) {
    const { t } = this.places[0].impacts;
    const [low, high] = this.window;
    const from = this.chosen?.time ?? low;
    const next = by > 0 ? lastUpTo(t, from) + 1 : lastUpTo(t, from - 1e-12 * Math.abs(from));
    if (by !== 0 && t[next] >= low && t[next] <= high) this.show({ panel: 0, place: 0, time: t[next], impact: next });
  }

  // The curves and impacts in view. What several curves have at one time stands in one row, and where a
  // curve jumps there are two.
  table() {
    const [low, high] = this.window;
    const rows = new Map();
    const columns = [axisName(this.time)];
    const add = (t, again, column, value) => {
      const key = `${t} ${again}`;
      if (!rows.has(key)) rows.set(key, { t, again, cells: [] });
      rows.get(key).cells.push([column, digits(value, 8)]);
    };
    for (const one of this.drawn) for (const { name, series: { x: t, y, title } } of this.curvesOf(one)) {
      if (!this.shows(title)) continue;
      const { unit, factor } = one.panel.y;
      const column = axisName({ name, unit });
      columns.push(column);
      for (let n = 0, again = 0; n < t.length; ++n) {
        if (!(t[n] >= low && t[n] <= high) || !Number.isFinite(y[n])) continue;
        again = n > 0 && t[n] === t[n - 1] ? again + 1 : 0;
        add(t[n], again, column, factor * y[n]);
      }
    }
    const { unit, factor } = this.drawn[this.places.length].panel.y;
    if (this.shows('impact')) for (const { name, impacts } of this.places) {
      const names = ['before', 'after'].map((when) => axisName({ name: `velocity ${when} the impact${name ? ` at ${name}` : ''}`, unit }));
      for (const k of impactsWithin(impacts, [low, high]))
        ['before', 'after'].forEach((when, n) => add(impacts.t[k], 0, names[n], factor * impacts[when][k]));
      if (impacts.t.length > 0) columns.push(...names);
    }
    const table = new CsvTable(columns);
    for (const { t, cells } of [...rows.values()].sort((a, b) => a.t - b.t || a.again - b.again))
      table.row([columns[0], digits(this.time.factor * t)], ...cells);
    return table;
  }
}
