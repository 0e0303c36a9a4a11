// What is told of one orbit: three pictures, its impacts, the command that makes it again.
import { init } from './echarts_parts.js';
import { axisName, element, measure, number, table } from './format.js';
import { circleOption, motionInks, portraitOption, seriesOption } from './orbit_charts.js';
import { Panel } from './panel.js';

const kMostImpacts = 200;  // listed
const kPictures = { series: 'Displacement over time', portrait: 'Phase portrait', circle: 'Multipliers in the unit circle' };

export class OrbitPanel {
  constructor(view, theme, resized, closed = () => {}) {
    Object.assign(this, { view, theme });
    this.panel = new Panel(Object.keys(kPictures), resized, () => { this.orbit = null; closed(); });
    this.places = document.querySelector('#orbit-place select');
    this.charts = null;
    this.places.addEventListener('change', () => this.draw());
    theme.onChange(() => this.draw());
    window.addEventListener('resize', () => this.fit());
  }

  // `asked`: the parameter's value of the point that was chosen, which may lie beside the orbit's.
  open(orbit, asked = null) {
    const opened = this.panel.open(orbit.name, this.factsOf(orbit));
    this.describe(orbit, asked);
    this.show(orbit);
    if (opened) this.panel.focus();
  }

  // Its pictures and its impacts; none with null.
  show(orbit) {
    this.orbit = orbit;
    const places = orbit?.places ?? [];
    this.places.replaceChildren(...places.map((place, i) => new Option(place.name, String(i))));
    document.getElementById('orbit-place').hidden = places.length < 2;
    for (const [name, what] of Object.entries(kPictures)) {
      const root = document.getElementById(`orbit-${name}`);
      root.hidden = orbit === null;
      if (orbit) root.setAttribute('aria-label', [`${what} of ${orbit.name}`, ...this.factsOf(orbit)].join(', '));
    }
    this.listImpacts(orbit?.impacts ?? [], orbit?.speed);
    if (orbit === null) return;
    this.charts ??= Object.keys(kPictures).map((name) => init(document.getElementById(`orbit-${name}`)));
    this.draw();
  }

  draw() {
    if (!this.orbit || !this.charts) return;
    const place = this.orbit.places[Number(this.places.value) || 0];
    const inks = motionInks(this.view, this.theme);
    const [series, portrait, circle] = this.charts;
    series.setOption(seriesOption(this.orbit, place, inks), true);
    portrait.setOption(portraitOption(this.orbit, place, inks), true);
    const root = circle.getDom();
    root.hidden = this.orbit.multipliers.length === 0;
    this.fit();
    if (!root.hidden)
      circle.setOption(circleOption(this.orbit, inks, { width: root.clientWidth, height: root.clientHeight }), true);
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
    if (orbit.clearance !== null) facts.push(`clearance between impacts ${measure(orbit.clearance, orbit.clearance.value, 4)}`);
    return facts;
  }

  describe(orbit, asked) {
    const { parameter } = this.view;
    const beside = parameter && asked !== null && orbit.value !== null && asked !== orbit.value;
    this.panel.tellRemark(
      beside ? `The page keeps not every orbit; this one, at ${measure(parameter, orbit.value, 8)}, is the nearest to the point chosen.` : '',
      orbit.remark);
    this.panel.tellCommand(orbit.command);
  }

  listImpacts(impacts, unit) {
    const root = document.getElementById('orbit-impacts');
    if (impacts.length === 0) return root.replaceChildren();
    const rows = impacts.slice(0, kMostImpacts).map(({ t, stop, speed }) => [number(t, 6), String(stop), number(unit.factor * speed, 6)]);
    const left = impacts.length - rows.length;
    return root.replaceChildren(
      table([['impact at (periods)', 'stop', axisName({ name: 'speed', unit: unit.unit })], ...rows]),
      left > 0 ? element('p', {}, `and ${left} more`) : '');
  }
}
