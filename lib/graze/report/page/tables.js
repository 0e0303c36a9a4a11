// Below the picture: tables that keys reach too, what the run said, and what made it.
import { element, table } from './format.js';

function folded(title, open, ...content) {
  const details = element('details', open ? { open: '' } : {}, element('summary', {}, title), ...content);
  return details;
}

function opener(text, open) {
  return element('button', { type: 'button', onclick: open }, text);
}

function madeBy(head, made) {
  const { graze } = head;
  const rows = Object.entries(graze.options).map(([name, value]) => [name, String(value)]);
  return folded('How this was made', false, element('pre', { tabindex: '0' }, made),
    table([['option', 'value'], ...rows, ['scene', graze.scene], ['SHA-256 of the scene in force', graze.scene_sha256]]));
}

// `open` shows a thing of the chart.
export function fillTables(root, view, open) {
  const parts = [];
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
