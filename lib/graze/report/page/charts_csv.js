// What a chart shows now as a table: the points in view of all that the legend shows.
import { plain } from './charts_view.js';
import { CsvTable, digits } from './csv_table.js';
import { axisName } from './format.js';

// The column of an axis, and a number along it as the column has it.
function columnOf(scale) {
  const decibel = scale.kind === 'decibel';
  return {
    name: plain(decibel ? scale.name : axisName(scale.quantity)),
    text: (number, count) => digits(decibel ? number : scale.quantity.factor * scale.back(number), count),
  };
}

// Of each panel those of x and of y; upright axes of one name are told apart by their panels.
function columnsOf(drawn) {
  const named = drawn.map(({ x, y }) => [columnOf(x), columnOf(y)]);
  const upright = named.map(([, { name }]) => name);
  return named.map(([x, y], i) => [x, upright.indexOf(y.name) === i ? y : { ...y, name: `${y.name}, panel ${i + 1}` }]);
}

export function chartsTable(view) {
  const { drawn, things, cells } = view;
  const table = new CsvTable(['series', ...(things ? ['of'] : [])]);
  const axes = columnsOf(drawn);
  for (const [x, y] of axes) for (const { name } of [x, y]) table.column(name);
  if (cells) addCells(table, cells, axes[0], view.inView(0), (title) => view.shows(title));
  for (const { panel, lines, i, x, y } of drawn) {
    const seen = view.inView(i);
    for (const line of lines) {
      const { series, of, which } = line;
      if (!view.shows(series.title)) continue;
      for (let k = 0; k < line.x.length; ++k) {
        if (!(line.x[k] >= seen.x[0] && line.x[k] <= seen.x[1] && line.y[k] >= seen.y[0] && line.y[k] <= seen.y[1])) continue;
        const exact = [x, y].map(({ quantity }) => (of && !series.x ? things.digitsOf(quantity, of[k], which[k]) : undefined));
        const cells = [['series', series.title], ...axes[i].map(({ name, text }, n) => [name, text(line[n === 0 ? 'x' : 'y'][k], exact[n])])];
        if (of) cells.push(['of', things.kindOf(of[k]).of]);
        if (series.error) cells.push([`± ${axes[i][1].name}`, digits(panel.y.factor * series.error[k])]);
        table.row(...cells);
      }
    }
  }
  return table;
}

// With the number that they show.
function addCells(table, cells, [x, y], seen, shows) {
  const { number, grounds, ground, things } = cells;
  if (number) table.column(axisName(number));
  for (let cell = 0; cell < ground.length; ++cell) {
    const kind = things.kindOf(cell);
    if (!kind || (!number && !shows(grounds[ground[cell]].title))) continue;
    const [across, up] = cells.placeOf(cell);
    if (!(across >= seen.x[0] && across <= seen.x[1] && up >= seen.y[0] && up <= seen.y[1])) continue;
    table.row(['series', 'cell'], ['of', kind.title], [x.name, x.text(across)], [y.name, y.text(up)],
      ...(!number ? [] : [[axisName(number), digits(number.factor * number.values[cell], 8)]]));
  }
}
