// The cells of a plane, a pixel each in an image of its own, which is drawn as large as the zoom asks
// for into the canvas under the chart: that a map has a million cells is not felt.

// Of "#RRGGBB" or [red, green, blue], as an ImageData has it.
export function pixelOf(colour) {
  const [red, green, blue] = typeof colour === 'string'
    ? [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)) : colour;
  return (0xff000000 | (blue << 16) | (green << 8) | red) >>> 0;
}

// The cells of an axis: `count` of them, `step` wide, from `low` on. Values may run either way.
export class CellAxis {
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

export class CellLayer {
  // `x`, `y`: a CellAxis each.
  constructor(canvas, x, y) {
    Object.assign(this, { canvas, x, y });
    this.image = document.createElement('canvas');
    this.image.width = x.count;
    this.image.height = y.count;
  }

  // `pixel(cell)`: its colour, 0 for none; cells are counted row by row.
  paint(pixel) {
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

  // `plane`: { left, top, right, bottom } in CSS pixels and the ranges { x, y } that it spans, SI.
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
