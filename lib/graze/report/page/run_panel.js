// Beside a motion: its phase portrait over the time in view, the moment that was chosen, the impacts,
// the command that follows it again.
import { init } from './echarts_parts.js';
import { axisName, element, measure, number, table } from './format.js';
import { motionInks, portraitOption } from './orbit_charts.js';
import { Panel } from './panel.js';

const kMostImpacts = 200;       // listed
const kMostPortrayed = 20_000;  // samples

// Of the impacts of a place those within [low, high] s.
export function impactsWithin({ t }, [low, high]) {
  const found = [];
  for (let i = 0; i < t.length; ++i) if (t[i] >= low && t[i] <= high) found.push(i);
  return found;
}

export class RunPanel {
  // `drawn`: the panels of the chart, of which the first show the displacements at the places, whose
  // velocities and impacts the view has; the next shows a velocity.
  constructor(view, drawn, theme) {
    Object.assign(this, { view, theme, pointed: null, kept: null });
    this.time = drawn[0].panel.x;
    this.runPlaces = view.places.map((place, i) => {
      const motion = drawn[i].lines.find(({ series }) => series.line)?.series;
      const { low, high } = drawn[i].panel.y;
      return { ...place, t: motion?.x ?? [], x: motion?.y ?? [], isNear: (stop) => stop.place >= low && stop.place <= high };
    });
    // Without the way that an axis counts, which the portrait tells.
    const quantity = (i) => ({ ...drawn[i].panel.y, name: drawn[i].panel.y.name.split('\n')[0] });
    Object.assign(this, { length: quantity(0), speed: quantity(view.places.length) });
    this.panel = new Panel(['portrait'], () => window.dispatchEvent(new Event('resize')));
    this.panel.keepOpen();
    this.panel.open('Phase portrait', []);
    this.panel.tellCommand(view.made);
    this.places = document.querySelector('#orbit-place select');
    this.places.replaceChildren(...this.runPlaces.map((place, i) => new Option(place.name, String(i))));
    this.places.addEventListener('change', () => this.look(this.window));
    document.getElementById('orbit-place').hidden = this.runPlaces.length < 2;
    this.chart = init(document.getElementById('orbit-portrait'));
    window.addEventListener('resize', () => this.chart.resize());
  }

  get index() { return Number(this.places.value) || 0; }
  get place() { return this.runPlaces[this.index]; }

  tellRemark() {
    const far = this.place.stops.filter((stop) => !this.place.isNear(stop))
      .map((stop) => `stop ${stop.index}, at ${measure(this.length, stop.place)}`);
    this.panel.tellRemark(
      this.place.t.length === 0 ? 'No samples were recorded.' : '',
      far.length > 0 ? `Beyond the picture ${far.length > 1 ? 'lie' : 'lies'} ${far.join(', ')}.` : '');
  }

  // Which stop an impact is on: the nearest of those that are approached that way.
  stopOf(place, impact) {
    const { stops, impacts } = this.runPlaces[place];
    const ahead = stops.filter((stop) => stop.sense * impacts.before[impact] > 0);
    const away = (stop) => Math.abs(stop.place - impacts.place[impact]);
    return (ahead.length > 0 ? ahead : stops).reduce((best, stop) => (away(stop) < away(best) ? stop : best)).index;
  }

  // [from, to] s.
  look(window) {
    this.window = window;
    const { time } = this;
    const inside = impactsWithin(this.place.impacts, window);
    const count = inside.length > 0 ? [`${inside.length} ${inside.length === 1 ? 'impact' : 'impacts'}`] : [];
    document.getElementById('orbit-facts').textContent =
      [`${measure(time, window[0])} to ${measure(time, window[1])}`, ...count].join(' · ');
    this.listImpacts(inside);
    this.tellRemark();
    const { theme, view } = this;
    const option = portraitOption({ period: null }, this.portrayed(), motionInks(view, theme), this);
    option.series.push(...['kept', 'pointed'].map((id) => ({
      id, type: 'scatter', silent: true, symbolSize: 10, z: 8, data: this.markAt(this[id]),
      itemStyle: { color: id === 'kept' ? theme.colours.ink : 'transparent', borderColor: theme.colours.ink, borderWidth: 2, opacity: 1 },
    })));
    this.chart.setOption(option, true);
    document.getElementById('orbit-portrait').setAttribute('aria-label',
      `Phase portrait from ${measure(time, window[0])} to ${measure(time, window[1])}`);
  }

  // The samples of the time in view, the last of them where they are many; cut where the velocity
  // jumps, as the portrait of an orbit has it.
  portrayed() {
    const { place } = this;
    const [low, high] = this.window;
    const seen = [];
    for (let i = 0; i < place.t.length; ++i) if (place.t[i] >= low && place.t[i] <= high) seen.push(i);
    const last = seen.slice(-kMostPortrayed);
    return {
      name: place.name, stops: place.stops.filter(place.isNear), t: last.map((i) => (Number.isFinite(place.v[i]) ? place.t[i] : NaN)), x: last.map((i) => place.x[i]), v: last.map((i) => place.v[i]),
    };
  }

  listImpacts(inside) {
    const { impacts } = this.place;
    const { time, speed } = this;
    const root = document.getElementById('orbit-impacts');
    if (inside.length === 0) return root.replaceChildren();
    const rows = inside.slice(0, kMostImpacts).map((k) => [
      number(time.factor * impacts.t[k], 7), String(this.stopOf(this.index, k)),
      ...[impacts.before, impacts.after].map((values) => number(speed.factor * values[k], 6))]);
    const left = inside.length - rows.length;
    return root.replaceChildren(
      table([[axisName({ name: 'impact at', unit: time.unit }), 'stop', axisName({ name: 'before', unit: speed.unit }), axisName({ name: 'after', unit: speed.unit })], ...rows]),
      left > 0 ? element('p', {}, `and ${left} more`) : '');
  }

  // Of a time: its point of the plane.
  markAt(time) {
    if (time === null) return [];
    const { t, x, v } = this.place;
    let best = -1;
    for (let i = 0; i < t.length; ++i)
      if (Number.isFinite(v[i]) && (best < 0 || Math.abs(t[i] - time) < Math.abs(t[best] - time))) best = i;
    return best < 0 ? [] : [[this.length.factor * x[best], this.speed.factor * v[best]]];
  }

  mark(id, time) {
    if (this[id] === time) return;
    this[id] = time;
    this.chart.setOption({ series: [{ id, data: this.markAt(time) }] });
  }

  point(time) { this.mark('pointed', time); }

  keep(time, rows) {
    this.mark('kept', time);
    this.panel.tellNumbers(rows);
  }
}
