// A line as far as it runs near the axes: next to a grazing a multiplier has no bound, and along a
// path of a billion pixels no canvas draws dashes.

// The part of a segment within a box, as [from, to] of its length; null where there is none (Liang,
// Barsky 1984).
function partWithin([ax, ay], [bx, by], box) {
  let from = 0, to = 1;
  for (const [at, along, [low, high]] of [[ax, bx - ax, box.x], [ay, by - ay, box.y]]) {
    if (along === 0) {
      if (at < low || at > high) return null;
      continue;
    }
    const ends = [(low - at) / along, (high - at) / along];
    from = Math.max(from, Math.min(...ends));
    to = Math.min(to, Math.max(...ends));
  }
  return from <= to ? [from, to] : null;
}

// Points of the line { x, y, ends }, broken by NaN behind nodes that end it and
// where it is out of reach: a span of the axes beyond their ends. `x`, `y`: [low, high].
export function nearAxes(line, x, y) {
  const wide = ([low, high]) => [low - (high - low), high + (high - low)];
  const box = { x: wide(x), y: wide(y) };
  const points = [];
  const gap = () => { if (points.length > 0 && !Number.isNaN(points.at(-1)[0])) points.push([NaN, NaN]); };
  for (let i = 0; i + 1 < line.x.length; ++i) {
    const a = [line.x[i], line.y[i]], b = [line.x[i + 1], line.y[i + 1]];
    const part = !line.ends?.[i] && [...a, ...b].every(Number.isFinite) ? partWithin(a, b, box) : null;
    if (!part) {
      gap();
      continue;
    }
    const at = (share) => (share === 0 ? a : share === 1 ? b : [0, 1].map((k) => a[k] + share * (b[k] - a[k])));
    if (part[0] > 0) gap();
    if (points.length === 0 || Number.isNaN(points.at(-1)[0])) points.push(at(part[0]));
    points.push(at(part[1]));
    if (part[1] < 1) gap();
  }
  gap();
  return points;
}
