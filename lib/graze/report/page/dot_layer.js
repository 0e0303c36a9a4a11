// Dots, written pixel by pixel into a canvas under the chart: a million of them take some ten
// milliseconds, so that they are drawn anew at every step of a zoom.
//
// A dot covers a square of pixels. Motions that repeat are opaque; of those that never do, dots on
// one pixel add up (each lets 1 - a of the ground through), so that where the motion is seen often
// is darker.

function channels(colour) {
  return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
}

export class DotLayer {
  constructor(canvas) {
    this.canvas = canvas;
  }

  // `panels`: { plane, clouds } each. `plane`: { left, top, right, bottom } in CSS pixels and the ranges
  // { x: [low, high], y: [low, high] } that it spans; `clouds`: { x, y, colour, fades }, with numbers along
  // the axes, those that lie on top last.
  draw(panels) {
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(this.canvas.clientWidth * ratio);
    this.canvas.height = Math.round(this.canvas.clientHeight * ratio);
    if (this.canvas.width === 0 || this.canvas.height === 0) return;
    for (const { plane, clouds } of panels) this.drawPanel(plane, clouds, ratio);
  }

  drawPanel(plane, clouds, ratio) {
    const box = {
      left: Math.round(plane.left * ratio), top: Math.round(plane.top * ratio),
      width: Math.round((plane.right - plane.left) * ratio),
      height: Math.round((plane.bottom - plane.top) * ratio),
    };
    if (clouds.length === 0 || box.width < 1 || box.height < 1) return;
    const context = this.canvas.getContext('2d');
    const image = context.createImageData(box.width, box.height);
    for (const cloud of clouds) {
      const count = counted(cloud, plane, box);
      if (count.total > 0) paint(image, count, dotSize(count.total, ratio), channels(cloud.colour), cloud.fades);
    }
    context.putImageData(image, box.left, box.top);
  }
}

// How many dots have their middle on each pixel.
function counted({ x, y }, plane, box) {
  const count = { pixels: new Uint16Array(box.width * box.height), total: 0 };
  const xScale = box.width / (plane.x[1] - plane.x[0]);
  const yScale = box.height / (plane.y[1] - plane.y[0]);
  for (let i = 0; i < x.length; ++i) {
    const across = Math.floor((x[i] - plane.x[0]) * xScale);
    const down = Math.floor((plane.y[1] - y[i]) * yScale);
    if (!(across >= 0 && across < box.width && down >= 0 && down < box.height)) continue;
    const at = down * box.width + across;
    if (count.pixels[at] < 65535) ++count.pixels[at];
    ++count.total;
  }
  return count;
}

// Device pixels: dots shrink as they crowd.
function dotSize(total, ratio) {
  const size = total < 3000 ? 3 : total < 30000 ? 2 : total < 200000 ? 1.5 : 1;
  return Math.max(1, Math.round(size * ratio));
}

function paint(image, count, size, [red, green, blue], fades) {
  const { width, height, data } = image;
  const mean = count.total * size * size / (width * height);
  const through = fades ? Math.max(0.1, Math.min(0.55, 0.35 + 0.25 * mean)) : 0;
  const before = Math.floor((size - 1) / 2);
  for (let at = 0; at < count.pixels.length; ++at) {
    if (count.pixels[at] === 0) continue;
    const x = at % width, y = (at - x) / width;
    const rest = fades ? through ** count.pixels[at] : 0;
    for (let j = Math.max(0, y - before); j < Math.min(height, y - before + size); ++j)
      for (let i = Math.max(0, x - before); i < Math.min(width, x - before + size); ++i) {
        const pixel = 4 * (j * width + i);
        data[pixel] = red;
        data[pixel + 1] = green;
        data[pixel + 2] = blue;
        data[pixel + 3] = 255 - (255 - (fades ? data[pixel + 3] : 0)) * rest;
      }
  }
}
