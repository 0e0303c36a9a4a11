// The phase portraits of several orbits in one picture; a click on a curve, or on its row in the
// table, opens it.
import { CsvTable, digits } from './csv_table.js';
import { axis, init, kCommon } from './echarts_parts.js';
import { ExportTools } from './export_tools.js';
import { axisName, measure } from './format.js';
import { Hover } from './hover.js';
import { Legend } from './legend.js';
import { lookSwatch, pen } from './marks.js';
import { jumpsOf, towards } from './orbit_charts.js';
import { ZoomTools } from './zoom_tools.js';

const kReach = 12;  // px

// A colour for each orbit, and the dashes of its stability.
function lookOf(orbit, i, { curves, lines }) {
  const id = !orbit.admissible ? 'open' : orbit.stable ? 'stable' : 'unstable';
  return { ...lines.find((line) => line.id === id), colour: curves[i % curves.length], width: 1.8 };
}

export class OrbitsView {
  constructor(view, orbits, theme, openOrbit) {
    Object.assign(this, { view, theme, openOrbit });
    this.orbits = Array.from({ length: orbits.count }, (_, i) => orbits.get(i));
    this.root = document.getElementById('chart');
    this.chart = init(this.root, null, { renderer: 'canvas' });
    this.hover = new Hover(document.getElementById('hover'), document.getElementById('ring'));
    document.getElementById('observables').hidden = true;
    const entries = this.orbits.map((orbit, i) => ({
      type: String(i), title: `${orbit.name}, ${orbit.stability}`, swatch: (drawnOn) => lookSwatch(lookOf(orbit, i, view.looks), drawnOn),
    }));
    this.legend = new Legend(document.getElementById('legend'), theme, entries, () => this.draw());
    this.zoom = new ZoomTools(this.chart, this.root);
    this.export = new ExportTools({ theme, chart: this.chart, legend: this.legend, table: () => this.table() });
    this.measureAxes();
    this.draw();
    this.listen();
  }

  // The place that the first orbit is seen at stands for all.
  places() {
    this.seen ??= this.orbits.map((orbit) => orbit.places.find((place) => place.name === this.orbits[0].places[0].name) ?? orbit.places[0]);
    return this.seen;
  }

  measureAxes() {
    const places = this.orbits.length > 0 ? this.places() : [];
    const displacements = [...places.flatMap((place) => [...place.x]), ...places.flatMap((place) => place.stops.map((stop) => stop.place))];
    const velocities = places.flatMap((place) => [...place.v]);
    // Of the largest motion, as on the axis of a picture.
    const unitOf = (name) => (places.length === 0 ? { factor: 1, unit: '' }
      : places.map((place) => place[name]).reduce((best, unit) => (unit.factor < best.factor ? unit : best)));
    const range = (values) => {
      const finite = values.filter(Number.isFinite);
      const low = finite.reduce((least, value) => Math.min(least, value), Infinity);
      const high = finite.reduce((most, value) => Math.max(most, value), -Infinity);
      const room = 0.07 * (high - low) || 1;
      return finite.length > 0 ? [low - room, high + room] : [-1, 1];
    };
    const way = this.orbits.length > 0 ? towards(this.orbits[0].places[0]) : '';
    this.x = { name: `displacement${way}`, range: range(displacements), ...unitOf('length') };
    this.y = { name: `velocity${way}`, range: range(velocities), ...unitOf('speed') };
  }

  series() {
    return this.orbits.flatMap((orbit, i) => {
      const place = this.places()[i], style = pen(lookOf(orbit, i, this.view.looks), this.theme);
      const shown = this.legend.shows(String(i));
      const line = (id, points, lineStyle) => ({
        id: `${id} ${i}`, type: 'line', showSymbol: false, silent: true, z: 3, lineStyle,
        data: shown ? points.map(([x, v]) => [this.x.factor * x, this.y.factor * v]) : [],
      });
      return [
        line('orbit', Array.from(place.t, (_, k) => [place.x[k], place.v[k]]), style),
        line('jumps', jumpsOf(orbit, place).flatMap(([from, to]) => [from, to, [NaN, NaN]]), { color: style.color, width: 1, type: [2, 3] }),
      ];
    });
  }

  draw() {
    const { colours } = this.theme;
    const named = (quantity, more) => axis(colours, axisName(quantity),
      quantity.factor * quantity.range[0], quantity.factor * quantity.range[1], more);
    const series = this.series();
    if (series.length > 0)
      series[0].markArea = {
        silent: true, data: this.places()[0].stops.map((stop) => [
          { xAxis: this.x.factor * stop.place, itemStyle: { color: this.theme.shade(this.view.looks.stop), opacity: 0.75 } },
          { xAxis: this.x.factor * this.x.range[stop.sense > 0 ? 1 : 0] },
        ]),
      };
    const zoom = (id, axes) => ({ id, type: 'inside', ...axes, filterMode: 'none', minSpan: 1e-6 });
    this.chart.setOption({
      ...kCommon, grid: { left: 76, right: 22, top: 16, bottom: 52 },
      xAxis: named(this.x, { nameGap: 30 }), yAxis: named(this.y, { nameGap: 54 }), series,
      dataZoom: [zoom('across', { xAxisIndex: 0 }), { ...zoom('upright', { yAxisIndex: 0 }), zoomOnMouseWheel: 'shift' }],
    }, { replaceMerge: ['series'] });
    this.tellRange();
  }

  // The part of the plane in view, for those who do not see it.
  tellRange() {
    const [x, y] = ['xAxis', 'yAxis'].map((name) => this.chart.getModel().getComponent(name).axis.scale.getExtent());
    this.root.setAttribute('aria-label', `Phase portraits: velocity from ${y.join(' to ')} ${this.y.unit} over ` +
      `displacement from ${x.join(' to ')} ${this.x.unit}. The table below opens each orbit.`);
  }

  // The points of the curves in view.
  table() {
    const [x, y] = ['xAxis', 'yAxis'].map((name) => this.chart.getModel().getComponent(name).axis.scale.getExtent());
    const names = ['time (forcing periods)', ...[this.x, this.y].map(({ name, unit }) => axisName({ name, unit }))];
    const table = new CsvTable(['orbit', 'stability', ...names]);
    this.places().forEach((place, i) => {
      if (!this.legend.shows(String(i))) return;
      for (let k = 0; k < place.t.length; ++k) {
        const values = [place.t[k], this.x.factor * place.x[k], this.y.factor * place.v[k]];
        if (!(values[1] >= x[0] && values[1] <= x[1] && values[2] >= y[0] && values[2] <= y[1])) continue;
        table.row(['orbit', `${i + 1} ${this.orbits[i].name}`], ['stability', this.orbits[i].stability], ...names.map((name, n) => [name, digits(values[n], 8)]));
      }
    });
    return table;
  }

  listen() {
    this.theme.onChange(() => { this.legend.draw(); this.draw(); });
    new ResizeObserver(() => { this.chart.resize(); this.hover.hide(); }).observe(this.root);
    this.chart.on('datazoom', () => { this.hover.hide(); this.tellRange(); });
    const zr = this.chart.getZr();
    zr.on('mousemove', (event) => {
      const found = this.nearest(event.offsetX, event.offsetY);
      zr.setCursorStyle(found ? 'pointer' : 'default');
      if (found) this.show(found);
      else this.hover.hide();
    });
    zr.on('globalout', () => this.hover.hide());
    zr.on('click', (event) => {
      const found = this.nearest(event.offsetX, event.offsetY);
      if (found) this.openOrbit(found.index);
    });
  }

  nearest(px, py) {
    let best = null, least = kReach;
    const toPixels = this.pixelMap();
    this.places().forEach((place, index) => {
      if (!this.legend.shows(String(index))) return;
      for (let k = 0; k < place.t.length; ++k) {
        const [x, y] = toPixels(place.x[k], place.v[k]);
        const distance = Math.hypot(x - px, y - py);
        if (distance < least) [least, best] = [distance, { index, x, y, place, k }];
      }
    });
    return best;
  }

  // From SI to pixels; the axes are linear, so two points tell all.
  pixelMap() {
    const corners = [0, 1].map((i) => [this.x.range[i], this.y.range[i]]);
    const [from, to] = corners.map(([x, v]) => this.chart.convertToPixel({ gridIndex: 0 }, [this.x.factor * x, this.y.factor * v]));
    const scale = [0, 1].map((i) => (to[i] - from[i]) / (corners[1][i] - corners[0][i]));
    return (x, v) => [from[0] + scale[0] * (x - corners[0][0]), from[1] + scale[1] * (v - corners[0][1])];
  }

  show({ index, x, y, place, k }) {
    const orbit = this.orbits[index];
    this.hover.show({ x, y }, orbit.name, [
      ['stability', orbit.stability], ['displacement', measure(this.x, place.x[k])],
      ['velocity', measure(this.y, place.v[k])],
    ], 'click: the orbit');
  }
}
