// Loci of special points over a map: lines with a border like the ground of the
// page, told apart by their dashes.
import { dotSwatch, kCodimensionTwo, kLocusKinds, lineSwatch } from './marks.js';

const kBorder = 1.6;  // px on both sides

export function lociEntries(view) {
  if (!view.loci) return [];
  const drawn = new Set(view.loci.lines.map(({ kind }) => kind));
  const entries = kLocusKinds.filter(({ type }) => drawn.has(type))
    .map((kind) => ({ ...kind, swatch: (colours) => lineSwatch(kind, colours) }));
  if (view.loci.special.length > 0)
    entries.push({ ...kCodimensionTwo, swatch: (colours) => dotSwatch(kCodimensionTwo, colours) });
  return entries;
}

// `shows(type)`: whether the legend has it switched on.
export function lociSeries(view, shows, colours) {
  if (!view.loci) return [];
  const at = (x, y) => [view.x.factor * x, view.y.factor * y];
  const series = [];
  kLocusKinds.forEach((kind, i) => {
    const line = view.loci.lines.find((part) => part.kind === kind.type);
    if (!line) return;
    const data = shows(kind.type) ? Array.from(line.x, (x, k) => at(x, line.y[k])) : [];
    const drawn = (id, z, lineStyle) => ({ id, type: 'line', data, showSymbol: false, silent: true, z, lineStyle });
    if (kind.colour !== 'paper')
      series.push(drawn(`border ${kind.type}`, 3 + i, { color: colours.paper, width: kind.width + 2 * kBorder, type: 'solid' }));
    series.push(drawn(`locus ${kind.type}`, 10 + i, { color: colours[kind.colour], width: kind.width, type: kind.dash }));
  });
  if (view.loci.special.length > 0)
    series.push({
      id: 'codimension two', type: 'scatter', silent: true, symbolSize: 7, z: 18,
      data: shows(kCodimensionTwo.type) ? view.loci.special.map(({ x, y }) => at(x, y)) : [],
      itemStyle: { color: colours.black, borderColor: colours.paper, borderWidth: 1, opacity: 1 },
    });
  return series;
}
