// The command line that follows the motion of one cell of a map.

function shellWord(word) {
  return /^[\w./=:,+@%-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

// Numbers of a list are all written as such with a fraction: TOML knows two kinds.
function list(numbers) {
  return `[${numbers.map((value) => (/[.e]/.test(String(value)) ? String(value) : `${value}.0`)).join(',')}]`;
}

// `values`: of the plane's axes. A coordinate of the start takes its place in the whole start.
export function cellCommand(view, values) {
  const settings = [];
  const start = { q: [...view.command.start?.q ?? []], qdot: [...view.command.start?.qdot ?? []] };
  let starts = false;
  [view.x, view.y].forEach((axis, i) => {
    const coordinate = axis.path.match(/^initial\.(q|qdot)\.(\d+)$/);
    if (coordinate) start[coordinate[1]][Number(coordinate[2]) - 1] = values[i];
    else settings.push(`${axis.path}=${values[i]}`);
    starts ||= coordinate !== null;
  });
  if (starts) settings.push(`initial.q=${list(start.q)}`, `initial.qdot=${list(start.qdot)}`);
  return view.command.before + settings.map((setting) => ` --set ${shellWord(setting)}`).join('') + view.command.after;
}
