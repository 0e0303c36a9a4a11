// Numbers as colours: a scale from `low` to `high` through evenly spaced colours, and the bar that
// tells of it.
import { axisName, element, number } from './format.js';
import { cellSwatch } from './marks.js';

// Of "#RRGGBB" or [red, green, blue], as an ImageData has it.
export function pixelOf(colour) {
  const [red, green, blue] = typeof colour === 'string'
    ? [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)) : colour;
  return (0xff000000 | (blue << 16) | (green << 8) | red) >>> 0;
}

const kSteps = 1024, kTics = 5;

// The pixel of a number; `none` is that of what is no number.
export function pixelScale({ low, high, colours }, none) {
  const channels = colours.map((colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)));
  const pixels = Uint32Array.from({ length: kSteps }, (_, i) => {
    const place = (i / (kSteps - 1)) * (colours.length - 1);
    const below = Math.min(Math.floor(place), colours.length - 2);
    return pixelOf([0, 1, 2].map((k) => Math.round(channels[below][k] + (place - below) * (channels[below + 1][k] - channels[below][k]))));
  });
  const scale = (kSteps - 1) / (high - low);
  return (value) => (Number.isFinite(value)
    ? pixels[Math.max(0, Math.min(kSteps - 1, Math.round((value - low) * scale)))] : none);
}

export function barTics(quantity) {
  return Array.from({ length: kTics }, (_, i) => quantity.low + (i / (kTics - 1)) * (quantity.high - quantity.low))
    .map((value) => number(quantity.factor * value, 3));
}

// `without`: names and colours of what has no number.
export function fillBar(root, quantity, without) {
  const scale = element('div', { class: 'scale' });
  scale.style.background = `linear-gradient(to right, ${quantity.colours.join(', ')})`;
  root.replaceChildren(
    element('span', {}, axisName(quantity)),
    element('div', { class: 'tics' }, scale, ...barTics(quantity).map((text) => element('span', {}, text))),
    ...without.map(([name, colour]) => element('span', { class: 'none' }, cellSwatch(colour), name)));
}
