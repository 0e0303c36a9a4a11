// What a diagram shows now as a table: dots, points of branches and special points in view of the axes,
// without what the legend hides.
import { CsvTable, digits } from './csv_table.js';
import { stripsOf } from './diagram_option.js';
import { axisName } from './format.js';
import { specialLook } from './marks.js';

const kDotDigits = 8;  // of what the program leaves in single precision

// The column of an axis, and a number along it as the column has it.
export function columnOf(scale) {
  const decibel = scale.kind === 'decibel';
  return {
    name: decibel ? scale.name : axisName(scale.quantity),
    text: (number, count) => digits(decibel ? number : scale.quantity.factor * scale.back(number), count),
  };
}

export function diagramTable(view, geometry, plane, shows) {
  const { looks, sweep } = view;
  const x = columnOf(geometry.x), y = columnOf(geometry.y);
  const table = new CsvTable(['series', 'of', x.name, y.name]);
  const isSeen = (place) => place.x >= plane.x[0] && place.x <= plane.x[1] && place.y >= plane.y[0] && place.y <= plane.y[1];
  const add = (series, of, place, count, exact = count) => {
    if (isSeen(place)) table.row(['series', series], ['of', of], [x.name, x.text(place.x, exact)], [y.name, y.text(place.y, count)]);
  };
  const { cloud } = geometry;
  const exact = geometry.x.quantity === view.parameter ? 15 : kDotDigits;
  const dots = [looks.dots.periodic, looks.dots.wild];
  for (let i = 0; i < (cloud?.x.length ?? 0); ++i) {
    const kind = dots[sweep.wild[cloud.row[i]]];
    if (kind && shows(kind.id))
      add(kind.title, sweep.labels[sweep.label[cloud.row[i]]], { x: cloud.x[i], y: cloud.y[i] }, geometry.y.quantity === view.parameter ? 15 : kDotDigits, exact);
  }
  for (const line of geometry.lines) {
    const look = looks.lines[line.kind], branch = view.branches[line.branch];
    if (!shows(look.id)) continue;
    for (let i = 0; i < line.x.length; ++i) add(look.title, `branch ${branch.id} ${branch.name}`, { x: line.x[i], y: line.y[i] });
  }
  for (const mark of geometry.marks)
    if (shows(mark.special.type)) add(specialLook(looks, mark.special.type).title, mark.special.id, mark);
  for (const strip of stripsOf(view, geometry.x)) addStrip(table, strip, looks, geometry.x, plane, shows);
  return table;
}

function addStrip(table, strip, looks, scale, plane, shows) {
  const x = columnOf(scale);
  const add = (look, { values, heights }) => values.forEach((value, i) => {
    const at = scale.of(value);
    if (at >= plane.x[0] && at <= plane.x[1] && Number.isFinite(heights[i]))
      table.row(['series', look.title], [x.name, x.text(at)], [axisName(strip), digits(strip.factor * heights[i], kDotDigits)]);
  });
  add(looks.dots.largest, strip);
  if (shows(looks.dots.lower.id)) add(looks.dots.lower, strip.lower);
}
