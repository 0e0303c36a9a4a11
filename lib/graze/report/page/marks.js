// How a look of the program (view.looks) is drawn: lines, marks and their samples in a legend.

// Paths in a box of 20 by 20.
const kPaths = {
  dot: 'M10 1A9 9 0 1 0 10 19A9 9 0 1 0 10 1Z',
  circle: 'M10 1A9 9 0 1 0 10 19A9 9 0 1 0 10 1Z',
  cross: 'M2 2L18 18M18 2L2 18',
  plus: 'M10 0V20M0 10H20',
  star: 'M10 0V20M0 10H20M3 3L17 17M17 3L3 17',
  square: 'M2 2H18V18H2Z',
  diamond: 'M10 0L20 10L10 20L0 10Z',
  up: 'M10 1L19.5 18H0.5Z',
  down: 'M10 19L19.5 2H0.5Z',
  pentagon: 'M10 0.5L19.5 7.4L15.9 18.6H4.1L0.5 7.4Z',
};
const kPoint = 1.1;      // px for a point of the pictures
const kMarkSize = 12;    // px
const kOutline = 1.8;    // px

// A line's style; `width` in its place where many lines lie close to each other.
export function pen(look, theme, width = look.width * kPoint) {
  const dashes = look.dashes.map((length) => length * Math.min(width, 2));
  return { color: theme.shade(look.colour), width, type: dashes.length > 0 ? dashes : 'solid' };
}

// What is larger, and open, is a ring about other marks.
const kLargestMark = 1.3;

// A mark's style, or that of `part` of its size. Open marks hide the line that they are on; rings about
// other marks hide nothing.
export function stamp(look, theme, part = 1) {
  const colour = theme.shade(look.colour);
  const open = look.size > kLargestMark ? 'transparent' : theme.colours.paper;
  return {
    symbol: `path://${kPaths[look.mark]}`, symbolSize: kMarkSize * look.size * part,
    itemStyle: { color: look.open ? open : colour, borderColor: colour, borderWidth: kOutline * part, opacity: 1 },
  };
}

const kSvg = 'http://www.w3.org/2000/svg';

function svg(tag, attributes) {
  const made = document.createElementNS(kSvg, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

function swatch(width, ...children) {
  const made = svg('svg', { width, height: 14, viewBox: `0 0 ${width} 14`, 'aria-hidden': 'true' });
  made.append(...children);
  return made;
}

function sampleLine(look, theme) {
  const { color, width, type } = pen(look, theme);
  return svg('line', {
    x1: 0, x2: 34, y1: 7, y2: 7, stroke: color, 'stroke-width': width, 'stroke-dasharray': type === 'solid' ? 'none' : type.join(' '),
  });
}

function sampleMark(look, theme, x) {
  const scale = 0.6 * Math.min(look.size, 1);  // what the legend has room for
  const colour = theme.shade(look.colour);
  return svg('path', {
    d: kPaths[look.mark], transform: `translate(${x - 10 * scale} ${7 - 10 * scale}) scale(${scale})`,
    fill: look.open || look.mark === 'cross' ? 'none' : colour, stroke: colour, 'stroke-width': 1.6 / scale,
  });
}

// Of what is drawn as a line, as marks, or as both.
export function lookSwatch(look, theme, { line = look.mark === 'none', marks = look.mark !== 'none' } = {}) {
  const parts = [];
  if (line) parts.push(sampleLine(look, theme));
  if (marks) parts.push(sampleMark(look, theme, line ? 17 : 7));
  return swatch(line ? 34 : 14, ...parts);
}

export function cellSwatch(colour) {
  return swatch(14, svg('rect', { x: 1, y: 1, width: 12, height: 12, fill: colour, stroke: '#808080', 'stroke-width': 0.6 }));
}
