// How the kinds of lines, marks and dots look: as in the pictures that gnuplot draws.

// By the number that stands for the kind in the data; drawn in this order.
export const kLineKinds = [
  { type: 'virtual', title: 'virtual', colour: 'grey', width: 1.1, dash: 'solid' },
  { type: 'open', title: 'stability open', colour: 'black', width: 2, dash: [2, 3] },
  { type: 'unstable', title: 'unstable', colour: 'vermillion', width: 2, dash: [7, 4] },
  { type: 'stable', title: 'stable', colour: 'blue', width: 2.4, dash: 'solid' },
];

// Loci over the colours of a map; those of no orbit of the system lie below.
export const kLocusKinds = [
  { type: 'virtual', title: 'virtual', colour: 'paper', width: 1.3, dash: 'solid' },
  { type: 'LP', title: 'fold (LP)', colour: 'black', width: 2.2, dash: 'solid' },
  { type: 'PD', title: 'period doubling (PD)', colour: 'black', width: 2.2, dash: [9, 4] },
  { type: 'NS', title: 'torus (NS)', colour: 'black', width: 2.2, dash: [9, 3, 2, 3] },
  { type: 'GR', title: 'grazing (GR)', colour: 'black', width: 2.2, dash: [2, 3] },
  { type: 'CH', title: 'completion (CH)', colour: 'black', width: 2.2, dash: [14, 3, 2, 3, 2, 3] },
];
export const kCodimensionTwo = { type: 'special', title: 'codimension two', colour: 'black' };

export const kDotKinds = [
  { type: 'periodic', title: 'sweep: periodic', colour: 'black' },
  { type: 'wild', title: 'sweep: not periodic', colour: 'grey' },
];

export const kLowerKind = { type: 'lower', title: 'other exponents', colour: 'orange' };

// Paths in a box of 20 by 20.
const kPaths = {
  circle: 'M10 1A9 9 0 1 0 10 19A9 9 0 1 0 10 1Z',
  cross: 'M2 2L18 18M18 2L2 18',
  square: 'M2 2H18V18H2Z',
  diamond: 'M10 0L20 10L10 20L0 10Z',
  up: 'M10 1L19.5 18H0.5Z',
  down: 'M10 19L19.5 2H0.5Z',
  pentagon: 'M10 0.5L19.5 7.4L15.9 18.6H4.1L0.5 7.4Z',
};

const kMarks = {
  LP: { title: 'fold (LP)', colour: 'black', path: kPaths.circle },
  BP: { title: 'branch point (BP)', colour: 'black', path: kPaths.cross },
  PD: { title: 'period doubling (PD)', colour: 'purple', path: kPaths.square, filled: true },
  NS: { title: 'torus (NS)', colour: 'sky', path: kPaths.diamond, filled: true },
  GR: { title: 'grazing (GR)', colour: 'green', path: kPaths.up },
  CH: { title: 'chatter ends (CH)', colour: 'orange', path: kPaths.down },
  LO: { title: 'lift-off (LO)', colour: 'orange', path: kPaths.pentagon },
  virtual: { title: 'virtual special point', colour: 'grey', path: kPaths.circle, filled: true, small: true },
};

export function markOf(type) {
  return kMarks[type] ?? { title: type, colour: 'black', path: kPaths.square };
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

// A line as pale as the paper is seen on a ground of its own.
export function lineSwatch(kind, colours) {
  const line = svg('line', {
    x1: 0, x2: 30, y1: 7, y2: 7, stroke: colours[kind.colour] ?? kind.colour,
    'stroke-width': kind.width, 'stroke-dasharray': kind.dash === 'solid' ? 'none' : kind.dash.join(' '),
  });
  const ground = svg('rect', { x: 0, y: 1, width: 30, height: 12, fill: colours.other });
  return kind.colour === 'paper' ? swatch(30, ground, line) : swatch(30, line);
}

export function dotSwatch(kind, colours) {
  return swatch(10, svg('circle', { cx: 5, cy: 7, r: 3, fill: colours[kind.colour] }));
}

export function cellSwatch(colour) {
  return swatch(14, svg('rect', { x: 1, y: 1, width: 12, height: 12, fill: colour, stroke: '#808080', 'stroke-width': 0.6 }));
}

export function markSwatch(mark, colours) {
  return swatch(14, svg('path', {
    d: mark.path, transform: `translate(1 1) scale(${mark.small ? 0.4 : 0.6})`,
    fill: mark.filled ? colours[mark.colour] : 'none', stroke: colours[mark.colour], 'stroke-width': 2.6,
  }));
}
