// What is told of a cell beside the picture: its numbers, a motion like its own, the command that follows it.
import { measure } from './format.js';

function shellWord(word) {
  return /^[\w./=:,+@%-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

// Numbers of a list are all written as such with a fraction: TOML knows two kinds.
function list(numbers) {
  return `[${numbers.map((value) => (/[.e]/.test(String(value)) ? String(value) : `${value}.0`)).join(',')}]`;
}

// `values`: of the plane's axes. A coordinate of the start takes its place in the whole start.
function cellCommand(command, values) {
  const settings = [];
  const start = Object.fromEntries(Object.entries(command.start ?? {}).map(([key, list]) => [key, [...list]]));
  let starts = false;
  command.paths.forEach((path, i) => {
    const coordinate = path.match(/^initial\.(q|qdot|displacement|velocity)\.(\d+)$/);
    if (coordinate) start[coordinate[1]][Number(coordinate[2]) - 1] = values[i];
    else settings.push(`${path}=${values[i]}`);
    starts ||= coordinate !== null;
  });
  if (starts) settings.push(...Object.keys(start).map((key) => `initial.${key}=${list(start[key])}`));
  return command.before + settings.map((setting) => ` --set ${shellWord(setting)}`).join('') + command.after;
}

// `told`: { messages, remarks, one, command } of the page's cells; `orbitPanel`: where it is told.
export function openCell(orbitPanel, cells, told, orbits, cell) {
  const { panel } = orbitPanel;
  const index = cells.orbitOf(cell);
  const orbit = index < 0 ? null : orbits.get(index);
  const opened = panel.open(cells.titleOf(cell), orbit ? orbitPanel.factsOf(orbit) : []);
  panel.tellNumbers(cells.valuesOf(cell, 7));
  panel.tellRemark(...remarksOn(cells, told, cell, orbit ? cells.things.kept[index] : cell), orbit?.remark);
  panel.tellCommand(cellCommand(told.command, cells.valuesAt(cell)));
  orbitPanel.show(orbit);
  if (opened) panel.focus();
}

// `shown`: the cell whose motion is.
function remarksOn(cells, { messages, remarks, one }, cell, shown) {
  const { x, y } = cells.panel;
  const kind = cells.things.kind[cell];
  const said = messages?.texts[messages.of[cell]];
  const [across, up] = cells.valuesAt(shown);
  return [
    said ? `${said[0].toUpperCase()}${said.slice(1)}.` : '',
    shown === cell || one[kind] ? '' : `The page keeps not every motion; this one, at ${x.name} ${measure(x, across, 7)} and ${y.name} ${measure(y, up, 7)}, is the nearest of its kind.`,
    remarks[kind] ?? '',
  ];
}
