// The beam bent over its length at a moment of the motion, its stops beside it; it plays.
import { axisName, measure, number } from './format.js';

const kWidth = 900, kHeight = 190, kLeft = 66, kRight = 16, kTop = 14, kBottom = 34;  // units of the drawing
const kSeconds = 8;  // that the window in view takes to play
const kSvg = 'http://www.w3.org/2000/svg';

function svg(tag, attributes, ...children) {
  const made = document.createElementNS(kSvg, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

// The displacement at every place of the beam at sample `k`: rows (places by modes) times q.
export function deflections(beam, k) {
  const modes = beam.rows.length / beam.x.length;
  return Array.from(beam.x, (_, i) => {
    let sum = 0;
    for (let j = 0; j < modes; ++j) sum += beam.rows[i * modes + j] * beam.q[k * modes + j];
    return sum;
  });
}

export class BeamFigure {
  // `view.beam`: x (m), rows (places by modes), t (s), q (samples by modes), stops [{ x, u, above }],
  // along and bent, the axes.
  constructor(root, view, theme) {
    Object.assign(this, { root, beam: view.beam, time: view.time, theme });
    root.hidden = false;
    this.slider = root.querySelector('input');
    this.button = root.querySelector('button');
    this.told = root.querySelector('output');
    this.slider.max = this.beam.t.length - 1;
    this.slider.addEventListener('input', () => this.show(Number(this.slider.value)));
    this.button.addEventListener('click', () => (this.playing ? this.pause() : this.play()));
    theme.onChange(() => this.draw());
    this.window = [-Infinity, Infinity];
    this.draw();
  }

  // What plays: the part of the motion that the picture above shows.
  look(window) { this.window = window; }

  across(x) { return kLeft + (kWidth - kLeft - kRight) * x / this.beam.x[this.beam.x.length - 1]; }
  up(u) {
    const { low, high } = this.beam.bent;
    return kTop + (kHeight - kTop - kBottom) * (high - u) / (high - low);
  }

  draw() {
    const { colours } = this.theme;
    const { along, bent, stops } = this.beam;
    const text = (x, y, anchor, words) => svg('text', { x, y, 'text-anchor': anchor, fill: colours.ink, 'font-size': 12 }, words);
    const line = (x1, y1, x2, y2, stroke, width = 1) => svg('line', { x1, y1, x2, y2, stroke, 'stroke-width': width });
    const end = this.beam.x[this.beam.x.length - 1];
    const drawing = svg('svg', { viewBox: `0 0 ${kWidth} ${kHeight}`, role: 'img' },
      line(kLeft, this.up(0), kWidth - kRight, this.up(0), colours.line),
      line(kLeft, kTop, kLeft, kHeight - kBottom, colours.ink, 3),
      text(kLeft - 8, this.up(bent.high) + 10, 'end', number(bent.factor * bent.high, 3)),
      text(kLeft - 8, this.up(bent.low), 'end', number(bent.factor * bent.low, 3)),
      text(kLeft - 8, this.up(0) + 4, 'end', '0'),
      text(kWidth - kRight, kHeight - kBottom + 16, 'end', number(along.factor * end, 3)),
      text((kLeft + kWidth) / 2, kHeight - 4, 'middle', axisName(along)),
      svg('text', { transform: `translate(13 ${kTop + (kHeight - kTop - kBottom) / 2}) rotate(-90)`, 'text-anchor': 'middle', fill: colours.ink, 'font-size': 12 }, axisName(bent)));
    for (const stop of stops) {
      const x = this.across(stop.x), y = Math.max(kTop - 8, Math.min(kHeight - kBottom + 8, this.up(stop.u)));
      const away = stop.above ? -9 : 9;
      drawing.append(svg('path', { d: `M${x} ${y}l-7 ${away}h14z`, fill: colours.faint }));
    }
    this.curve = svg('path', { fill: 'none', stroke: this.theme.shade('#0072B2'), 'stroke-width': 3, 'stroke-linecap': 'round' });
    drawing.append(this.curve);
    this.root.querySelector('div').replaceChildren(drawing);
    this.show(Number(this.slider.value));
  }

  show(k) {
    const u = deflections(this.beam, k);
    const points = u.map((value, i) => `${this.across(this.beam.x[i]).toFixed(1)} ${this.up(value).toFixed(2)}`);
    this.curve.setAttribute('d', `M${points.join('L')}`);
    this.slider.value = k;
    this.told.textContent = `t = ${measure(this.time, this.beam.t[k], 5)}, tip at ${measure(this.beam.bent, u[u.length - 1], 4)}`;
  }

  // The sample at a time, or the last before it.
  showTime(time) {
    const k = this.beam.t.findLastIndex((t) => t <= time);
    this.show(Math.max(0, k));
  }

  play() {
    const { t } = this.beam;
    const first = Math.max(0, t.findIndex((time) => time >= this.window[0]));
    const last = t.findLastIndex((time) => time <= this.window[1]);
    if (last <= first) return;
    let from = Number(this.slider.value);
    if (from < first || from >= last) from = first;
    this.button.textContent = 'Pause';
    this.playing = true;
    const perSecond = (t[last] - t[first]) / kSeconds;
    const begun = performance.now();
    const step = (now) => {
      if (!this.playing) return;
      const time = t[from] + perSecond * (now - begun) / 1000;
      this.showTime(Math.min(time, t[last]));
      if (time >= t[last]) this.pause();
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  pause() {
    this.playing = false;
    this.button.textContent = 'Play';
  }
}
