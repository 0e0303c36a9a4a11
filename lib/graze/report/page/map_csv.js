// What a map shows now as a table: its cells and loci in view, without what the legend hides.
import { CsvTable, digits } from './csv_table.js';
import { axisName } from './format.js';
import { codimensionTwoMarks, shownLoci } from './loci_layer.js';

// `number`: what colours tell, or null where they tell kinds; `valuesAt(cell)`: SI; `plane`: in view, SI.
export function mapTable(view, number, valuesAt, plane, shows) {
  const { x, y, cells } = view;
  const first = axisName(x), second = axisName(y);
  const more = number ? [axisName(number)] : [];
  const table = new CsvTable(['series', 'of', first, second, ...more]);
  const isSeen = (u, v) => u >= plane.x[0] && u <= plane.x[1] && v >= plane.y[0] && v <= plane.y[1];
  const add = (series, of, u, v, ...rest) => {
    if (isSeen(u, v))
      table.row(['series', series], ['of', of], [first, digits(x.factor * u)], [second, digits(y.factor * v)], ...rest);
  };
  for (let cell = 0; cell < (cells?.kind.length ?? 0); ++cell) {
    const kind = cells.kinds[cells.kind[cell]];
    if (!kind || (!number && !shows(String(kind.entry)))) continue;
    add('cell', kind.name, ...valuesAt(cell), ...more.map((name) => [name, digits(number.factor * number.values[cell], 8)]));
  }
  for (const { look, line } of shownLoci(view, shows))
    line.x.forEach((u, k) => { if (Number.isFinite(u)) add('locus', look.title, u, line.y[k]); });
  for (const { special } of codimensionTwoMarks(view, shows)) add('codimension two', special.id, special.x, special.y);
  return table;
}
