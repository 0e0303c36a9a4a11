// Loci of special points over a map: lines with a border like the ground of the page, which are seen
// on any colour, and the points of codimension two with their names.
import { markLabel } from './charts_option.js';
import { lookEntry } from './legend.js';
import { pen, stamp } from './marks.js';
import { nearestMark, nearestNode } from './nearest.js';

const kBorder = 1.6;  // px on both sides

// In the order of the legend; what is no orbit of the system lies below the others.
function locusLooks({ looks, loci }) {
  const drawn = new Set((loci?.lines ?? []).map(({ kind }) => kind));
  return looks.loci.filter(({ id }) => drawn.has(id));
}

// What a locus is called in the legend, where kinds of cells have names of their own.
const typeOf = (look) => `locus ${look.id}`;

export function lociEntries(view) {
  if (!view.loci) return [];
  const entries = locusLooks(view).map((look) => lookEntry(look, typeOf(look)));
  if (view.loci.special.length > 0) entries.push(lookEntry(view.looks.codimension_two));
  return entries;
}

// Points of codimension two that the legend shows, as { special, x, y } with numbers along the axes.
export function codimensionTwoMarks(view, shows) {
  if (!view.loci || !shows(view.looks.codimension_two.id)) return [];
  return view.loci.special.map((special) => ({ special, x: view.x.factor * special.x, y: view.y.factor * special.y }));
}

// Lines that the legend shows, with their looks.
export function shownLoci(view, shows) {
  return locusLooks(view).filter((look) => shows(typeOf(look)))
    .map((look) => ({ look, line: view.loci.lines.find(({ kind }) => kind === look.id) }));
}

// `shows(type)`: whether the legend has it switched on; `labels`: whether points are named.
export function lociSeries(view, shows, theme, labels) {
  if (!view.loci) return [];
  const shown = new Map(shownLoci(view, shows).map(({ look, line }) => [look.id, line]));
  const series = [];
  locusLooks(view).forEach((look, i) => {
    const line = shown.get(look.id);
    const data = line ? Array.from(line.x, (x, k) => [view.x.factor * x, view.y.factor * line.y[k]]) : [];
    const drawn = (id, z, lineStyle) => ({ id, type: 'line', data, showSymbol: false, silent: true, z, lineStyle });
    const style = pen(look, theme);
    const below = look.id === 'virtual' ? -1 : 0;
    if (view.cells) series.push(drawn(`border ${look.id}`, 3 + i, { color: theme.colours.paper, width: style.width + 2 * kBorder, type: 'solid' }));
    series.push(drawn(`locus ${look.id}`, 10 + i + 10 * below, style));
  });
  if (view.loci.special.length > 0)
    series.push({
      id: 'codimension two', type: 'scatter', silent: true, z: 20, ...stamp(view.looks.codimension_two, theme, 0.8),
      data: codimensionTwoMarks(view, shows).map(({ special, x, y }) => ({ value: [x, y], name: special.id })),
      label: markLabel(theme, labels), labelLayout: { hideOverlap: true },
    });
  return series;
}

// The point of codimension two, or else of a locus, within reach of a place in pixels, as { title, x, y }
// with SI values; null without any.
export function nearestOfLoci(view, shows, plane, [px, py], reach) {
  if (!view.loci) return null;
  const perPixel = {
    x: (plane.x[1] - plane.x[0]) / (plane.right - plane.left), y: (plane.y[1] - plane.y[0]) / (plane.bottom - plane.top),
  };
  const place = { x: plane.x[0] + (px - plane.left) * perPixel.x, y: plane.y[1] - (py - plane.top) * perPixel.y };
  if (px < plane.left || px > plane.right || py < plane.top || py > plane.bottom) return null;
  const marks = shows(view.looks.codimension_two.id) ? view.loci.special : [];
  const mark = nearestMark(marks, place, perPixel, reach, () => true);
  if (mark) return { title: mark.title, x: mark.x, y: mark.y };
  const lines = shownLoci(view, shows).map(({ look, line }) => ({ look, ...line }));
  const node = nearestNode(lines, place, perPixel, 0.7 * reach, () => true);
  return node && { title: node.line.look.title, x: node.x, y: node.y };
}
