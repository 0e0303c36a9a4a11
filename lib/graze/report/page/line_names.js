// Where the names of lines stand, "(1,1)": one for all that are of the same, in the middle of the longest
// part of them that is in view. `inView`: { x: [low, high], y: [low, high] }, numbers along the axes.
export function lineNames(lines, things, { x, y }) {
  const longest = new Map();
  for (const line of lines)
    for (let i = 0, from = 0; i <= line.x.length; ++i) {
      if (line.x[i] >= x[0] && line.x[i] <= x[1] && line.y[i] >= y[0] && line.y[i] <= y[1]) continue;
      const part = { line, from, count: i - from };
      from = i + 1;
      const { of, name } = kindOf(part, things);
      if (name && part.count > (longest.get(of)?.count ?? 0)) longest.set(of, { ...part, name });
    }
  return [...longest.values()].map(({ line, from, count, name }) => {
    const middle = from + Math.floor(count / 2);
    return { value: [line.x[middle], line.y[middle]], name };
  });
}

// What a part of a line is of; a special point on it is called by its own name.
function kindOf({ line, from, count }, things) {
  for (let i = from; i < from + count; ++i) {
    const kind = things.kindOf(line.of[i]);
    if (kind.name !== kind.of) return kind;
  }
  return {};
}
