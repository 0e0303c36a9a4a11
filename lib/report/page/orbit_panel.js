// What is told of one orbit: three pictures, its impacts, the command that makes it again.
import { init } from './echarts_parts.js';
import { element, measure, number, table } from './format.js';
import { circleOption, portraitOption, seriesOption } from './orbit_charts.js';
import { Panel } from './panel.js';

const kMostImpacts = 200;  // listed

export class OrbitPanel {
  constructor(view, theme, resized) {
    Object.assign(this, { view, theme });
    this.panel = new Panel(['series', 'portrait', 'circle'], resized, () => { this.orbit = null; });
    this.places = document.querySelector('#orbit-place select');
    this.charts = null;
    this.places.addEventListener('change', () => this.draw());
    theme.onChange(() => this.draw());
    window.addEventListener('resize', () => this.fit());
  }

  // `asked`: the parameter's value of the point that was chosen, which may lie beside the orbit's.
  open(orbit, asked = null) {
    this.orbit = orbit;
    const facts = this.factsOf(orbit);
    const opened = this.panel.open(orbit.name, facts);
    this.describe(asked, facts);
    this.places.replaceChildren(...orbit.places.map((place, i) => new Option(place.name, String(i))));
    document.getElementById('orbit-place').hidden = orbit.places.length < 2;
    this.charts ??= ['series', 'portrait', 'circle'].map((name) => init(document.getElementById(`orbit-${name}`)));
    this.draw();
    if (opened) this.panel.focus();
  }

  draw() {
    if (!this.orbit || !this.charts) return;
    const place = this.orbit.places[Number(this.places.value) || 0];
    const { colours } = this.theme;
    const [series, portrait, circle] = this.charts;
    series.setOption(seriesOption(this.orbit, place, colours), true);
    portrait.setOption(portraitOption(this.orbit, place, colours), true);
    const root = circle.getDom();
    root.hidden = this.orbit.multipliers.length === 0;
    this.fit();
    if (!root.hidden)
      circle.setOption(circleOption(this.orbit, colours, { width: root.clientWidth, height: root.clientHeight }), true);
  }

  fit() {
    if (this.orbit) for (const chart of this.charts ?? []) chart.resize();
  }

  factsOf(orbit) {
    const facts = [];
    const { parameter } = this.view;
    if (parameter && orbit.value !== null) facts.push(`${parameter.name} ${measure(parameter, orbit.value, 8)}`);
    if (orbit.stability) facts.push(orbit.stability);
    if (orbit.multipliers.length > 0)
      facts.push(`largest multiplier ${number(Math.max(...orbit.multipliers.map(([re, im]) => Math.hypot(re, im))), 4)} in modulus`);
    if (orbit.clearance !== null) facts.push(`clearance between impacts ${number(1e3 * orbit.clearance, 4)} mm`);
    return facts;
  }

  describe(asked, facts) {
    const { orbit } = this;
    const { parameter } = this.view;
    const beside = parameter && asked !== null && orbit.value !== null && asked !== orbit.value;
    this.panel.tellRemark(
      beside ? `The page keeps not every orbit; this one, at ${measure(parameter, orbit.value, 8)}, is the nearest to the point chosen.` : '',
      orbit.remark);
    this.panel.tellCommand(orbit.command);
    this.listImpacts();
    const about = `of ${orbit.name}${facts.length ? `, ${facts.join(', ')}` : ''}`;
    for (const [name, what] of [['series', 'Displacement over time'], ['portrait', 'Phase portrait'], ['circle', 'Multipliers in the unit circle']])
      document.getElementById(`orbit-${name}`).setAttribute('aria-label', `${what} ${about}`);
  }

  listImpacts() {
    const { impacts } = this.orbit;
    const root = document.getElementById('orbit-impacts');
    if (impacts.length === 0) return root.replaceChildren();
    const rows = impacts.slice(0, kMostImpacts).map(({ t, stop, speed }) => [number(t, 6), String(stop), number(speed, 6)]);
    const left = impacts.length - rows.length;
    return root.replaceChildren(
      table([['impact at (periods)', 'stop', 'speed (m/s)'], ...rows]),
      left > 0 ? element('p', {}, `and ${left} more`) : '');
  }
}
