// The cells of a panel, which are the first things of its chart: a pixel each in an image of its own, which
// is drawn as large as the zoom asks for into the canvas under the chart, so that a million cells are not
// felt. They show what they are, by grounds, or one of their numbers, by a bar of colours.
import { barTics, fillBar, pixelOf, pixelScale } from './colour_bar.js';
import { axisName, measure } from './format.js';

// The cells of an axis: `count` of them, `step` wide, from `low` on. Values may run either way.
class CellAxis {
  constructor(values) {
    this.count = values.length;
    this.falls = values[0] > values[values.length - 1];
    const [least, most] = this.falls ? [values[values.length - 1], values[0]] : [values[0], values[values.length - 1]];
    this.step = (most - least) / (this.count - 1);
    this.low = least - 0.5 * this.step;
  }

  // From the low end; and its index in the list of values.
  placeOf(value) { return Math.floor((value - this.low) / this.step); }
  index(place) { return this.falls ? this.count - 1 - place : place; }

  // The places of which something lies between two values, as [from, to).
  placesBetween(low, high) {
    const within = (place) => Math.max(0, Math.min(this.count, place));
    return [within(this.placeOf(low)), within(this.placeOf(high) + 1)];
  }
}

export class Cells {
  // `panel`: with cells; `scales`: { x, y }, of its axes; `changed` is called when others are shown.
  constructor(canvas, panel, scales, things, none, changed) {
    Object.assign(this, { canvas, panel, scales, things, none, ...panel.cells });
    const along = (name, values) => new CellAxis(Array.from(values, (value) => scales[name].of(value)));
    this.x = along('x', this.columns);
    this.y = along('y', this.rows);
    this.image = document.createElement('canvas');
    this.image.width = this.x.count;
    this.image.height = this.y.count;
    this.numbers = things.numbers.filter(({ colours }) => colours);
    this.number = this.numbers.find(({ key }) => key === this.shown) ?? null;
    const select = document.getElementById('observable');
    for (const { key, name } of [{ key: 'attractor', name: this.name }, ...this.numbers]) select.add(new Option(name, key));
    select.value = this.number?.key ?? 'attractor';
    select.addEventListener('change', () => {
      this.number = this.numbers.find(({ key }) => key === select.value) ?? null;
      changed();
    });
  }

  // Titles and colours that a legend has.
  get entries() { return this.number ? [] : this.grounds; }

  // Every cell its colour, and the bar that tells of it.
  paint(theme, shows) {
    const root = document.getElementById('bar');
    root.hidden = this.number === null;
    if (this.number) {
      this.paintNumbers(theme, root);
    } else {
      const pixels = this.grounds.map(({ title, colour }) => (shows(title) ? pixelOf(theme.shade(colour)) : 0));
      this.fill((cell) => pixels[this.ground[cell]] ?? 0);
    }
  }

  // What is clear of the stops is blank, as in the pictures.
  paintNumbers(theme, root) {
    const { values } = this.number;
    const none = theme.shade(this.none), { kind, kinds } = this.things;
    const clear = kinds.map(({ title }) => title.startsWith('no impact'));
    const pixel = pixelScale(this.number, pixelOf(none));
    const isBlank = (cell) => clear[kind[cell]] && !Number.isFinite(values[cell]);
    let blanks = 0, missing = 0;
    this.fill((cell) => {
      if (isBlank(cell)) ++blanks;
      else if (kinds[kind[cell]] && !Number.isFinite(values[cell])) ++missing;
      return kinds[kind[cell]] && !isBlank(cell) ? pixel(values[cell]) : 0;
    });
    fillBar(root, this.number, [
      ...(blanks > 0 ? [['no impact (blank)', theme.colours.paper]] : []), ...(missing > 0 ? [['no number', none]] : [])]);
  }

  // For the image of the picture.
  get bar() { return this.number && { name: axisName(this.number), colours: this.number.colours, tics: barTics(this.number) }; }

  // `pixel(cell)`: its colour, 0 for none; cells are counted row by row.
  fill(pixel) {
    const context = this.image.getContext('2d');
    const data = context.createImageData(this.x.count, this.y.count);
    const pixels = new Uint32Array(data.data.buffer);
    let at = 0;
    for (let row = this.y.count; row-- > 0;) {
      const first = this.y.index(row) * this.x.count;
      for (let column = 0; column < this.x.count; ++column) pixels[at++] = pixel(first + this.x.index(column));
    }
    context.putImageData(data, 0, 0);
  }

  cellAt({ left, right, top, bottom, x, y }, [px, py]) {
    if (px < left || px > right || py < top || py > bottom) return null;
    const column = this.x.placeOf(x[0] + ((px - left) / (right - left)) * (x[1] - x[0]));
    const row = this.y.placeOf(y[1] - ((py - top) / (bottom - top)) * (y[1] - y[0]));
    if (column < 0 || column >= this.x.count || row < 0 || row >= this.y.count) return null;
    return this.y.index(row) * this.x.count + this.x.index(column);
  }

  has(thing) { return thing < this.x.count * this.y.count; }

  // SI; and as numbers along the axes.
  valuesAt(cell) {
    const column = cell % this.x.count;
    return [this.columns[column], this.rows[(cell - column) / this.x.count]];
  }
  placeOf(cell) {
    const [x, y] = this.valuesAt(cell);
    return [this.scales.x.of(x), this.scales.y.of(y)];
  }

  titleOf(cell) { return this.things.kindOf(cell)?.title ?? 'not run'; }

  // Names and values of a cell.
  valuesOf(cell, digits) {
    const { x, y } = this.panel;
    const [across, up] = this.valuesAt(cell);
    const told = (number) => {
      const value = number.values[cell];
      return [number.name, value === -Infinity ? '−∞' : Number.isFinite(value) ? measure(number, value, digits) : '–'];
    };
    return [[x.name, measure(x, across, 7)], [y.name, measure(y, up, 7)], ...this.numbers.map(told)];
  }

  // The cell beside, as seen; the one in the middle where there is none yet.
  beside(cell, across, up) {
    const from = cell ?? this.y.index(this.y.count >> 1) * this.x.count + this.x.index(this.x.count >> 1);
    const next = (axis, at, by) => axis.index(Math.max(0, Math.min(axis.count - 1, axis.index(at) + by)));
    return next(this.y, Math.floor(from / this.x.count), up) * this.x.count + next(this.x, from % this.x.count, across);
  }

  // The orbit that the page keeps of the nearest cell of its kind; -1 without any.
  orbitOf(cell) {
    const { count } = this.x;
    return this.things.orbitOf(cell, (a, b) => Math.hypot((a % count - b % count) / count, (Math.floor(a / count) - Math.floor(b / count)) / this.y.count));
  }

  // `plane`: { left, top, right, bottom } in CSS pixels and the ranges { x, y } that it spans, numbers along the axes.
  draw(plane) {
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(this.canvas.clientWidth * ratio);
    this.canvas.height = Math.round(this.canvas.clientHeight * ratio);
    if (this.canvas.width === 0 || this.canvas.height === 0) return;
    const context = this.canvas.getContext('2d');
    context.imageSmoothingEnabled = false;  // no colour that no cell has
    context.scale(ratio, ratio);
    context.beginPath();
    context.rect(plane.left, plane.top, plane.right - plane.left, plane.bottom - plane.top);
    context.clip();
    const [left, right] = this.x.placesBetween(...plane.x);
    const [low, high] = this.y.placesBetween(...plane.y);
    if (left >= right || low >= high) return;
    const xScale = (plane.right - plane.left) / (plane.x[1] - plane.x[0]);
    const yScale = (plane.bottom - plane.top) / (plane.y[1] - plane.y[0]);
    context.drawImage(this.image, left, this.y.count - high, right - left, high - low,
      plane.left + (this.x.low + left * this.x.step - plane.x[0]) * xScale,
      plane.top + (plane.y[1] - this.y.low - high * this.y.step) * yScale,
      (right - left) * this.x.step * xScale, (high - low) * this.y.step * yScale);
  }
}
