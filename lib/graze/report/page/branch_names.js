// Where the names of branches stand, "(1,1)": one a branch, in the middle of the longest part of its
// lines that is in view. `inView`: { x: [low, high], y: [low, high] }, numbers along the axes.
export function branchNames(view, lines, { x, y }) {
  const longest = new Map();
  for (const line of lines) {
    const part = longestPart(line, (i) => line.x[i] >= x[0] && line.x[i] <= x[1] && line.y[i] >= y[0] && line.y[i] <= y[1]);
    if (part.count > (longest.get(line.branch)?.count ?? 0)) longest.set(line.branch, { ...part, line });
  }
  return [...longest].map(([branch, { from, count, line }]) => {
    const middle = from + Math.floor(count / 2);
    return { value: [line.x[middle], line.y[middle]], name: view.branches[branch].name };
  });
}

// Of nodes one after the other that are within: the first, and how many.
function longestPart(line, isWithin) {
  let part = { from: 0, count: 0 };
  for (let i = 0, from = 0; i < line.x.length; ++i) {
    if (!isWithin(i)) from = i + 1;
    else if (i + 1 - from > part.count) part = { from, count: i + 1 - from };
  }
  return part;
}
