// Below the picture: special points or orbits as a table that keys reach too, what the run said, and
// what made it.
import { element, measure, number, table } from './format.js';

function folded(title, open, ...content) {
  const details = element('details', open ? { open: '' } : {}, element('summary', {}, title), ...content);
  return details;
}

function opener(text, open) {
  return element('button', { type: 'button', onclick: open }, text);
}

function orbitTable(view, orbits, openOrbit) {
  const rows = Array.from({ length: orbits.count }, (_, i) => {
    const orbit = orbits.get(i);
    const fastest = Math.max(...orbit.impacts.map((impact) => impact.speed));
    return [opener(orbit.name, () => openOrbit(i)), orbit.stability, String(orbit.impacts.length), orbit.impacts.length > 0 ? measure(orbit.speed, fastest) : '–'];
  });
  return table([['orbit', '', 'impacts', 'fastest'], ...rows]);
}

// What the cells of a map settle on; the label opens the first cell that does.
function kindTable(view, openCell) {
  const { kinds, kind } = view.cells;
  const columns = view.x.values.length;
  const rows = kinds.filter(({ cells }) => cells > 0).map(({ name, cells, first }) => [
    opener(name, () => openCell(first)), String(cells), `${number((100 * cells) / kind.length, 4)} %`,
    measure(view.x, view.x.values[first % columns], 7), measure(view.y, view.y.values[Math.floor(first / columns)], 7)]);
  return folded(`${rows.length} kinds of cells`, rows.length <= 12,
    table([[view.cells.name, 'cells', 'part', `first at ${view.x.name}`, view.y.name], ...rows]));
}

function codimensionTwoTable(view) {
  const rows = view.loci.special.map((special) => [
    special.title, measure(view.x, special.x, 10), measure(view.y, special.y, 10)]);
  return folded(`${rows.length} points of codimension two`, rows.length <= 12, table([['special point', view.x.name, view.y.name], ...rows]));
}

function madeBy(head, made) {
  const { graze } = head;
  const rows = Object.entries(graze.options).map(([name, value]) => [name, String(value)]);
  return folded('How this was made', false, element('pre', { tabindex: '0' }, made),
    table([['option', 'value'], ...rows, ['scene', graze.scene], ['SHA-256 of the scene in force', graze.scene_sha256]]));
}

// `open` shows an orbit of the page, or a cell of a map.
export function fillTables(root, view, orbits, open) {
  const parts = [];
  if (view.kind === 'map' && view.cells) parts.push(kindTable(view, open));
  if (view.loci?.special.length > 0) parts.push(codimensionTwoTable(view));
  if (view.kind === 'orbits' && orbits.count > 0) parts.push(orbitTable(view, orbits, open));
  for (const { name, columns, rows, opens } of view.tables ?? [])
    parts.push(folded(name, rows.length <= 12, table([columns, ...rows.map(([first, ...cells], i) => [
      opens[i] >= 0 ? opener(first, () => open(opens[i])) : first, ...cells])])));
  const said = [...(view.head.warnings ?? []), ...(view.notes ?? [])];
  if (said.length > 0)
    parts.push(folded(`${said.length} ${said.length === 1 ? 'note' : 'notes'} of the run`, said.length <= 3,
      element('ul', {}, ...said.map((note) => element('li', {}, note)))));
  parts.push(madeBy(view.head, view.made));
  root.replaceChildren(...parts);
}
