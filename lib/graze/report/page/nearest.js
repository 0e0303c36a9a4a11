// What of a picture over a parameter is nearest to a place, as { kind, .. , value, height, distance }
// with the distance in pixels; null where nothing is within reach.

// Sweeps run either way; the rows between two values, as indices [from, to).
function rowsBetween(values, low, high) {
  const falls = values.length > 1 && values[0] > values[values.length - 1];
  const first = (isPast) => {
    let from = 0, to = values.length;
    while (from < to) {
      const middle = (from + to) >> 1;
      if (isPast(values[middle])) to = middle;
      else from = middle + 1;
    }
    return from;
  };
  return falls ? [first((v) => v <= high), first((v) => v < low)]
    : [first((v) => v >= low), first((v) => v > high)];
}

// `place`: SI { x, y }; `perPixel`: SI per pixel { x, y }.
export function nearestDot(sweep, heights, place, perPixel, reach, shows) {
  let best = null, least = reach * reach;
  const [from, to] = rowsBetween(sweep.values, place.x - reach * perPixel.x, place.x + reach * perPixel.x);
  for (let row = from; row < to; ++row) {
    if (!shows(sweep.wild[row] === 1 ? 'wild' : 'periodic')) continue;
    const dx = (sweep.values[row] - place.x) / perPixel.x;
    for (let i = sweep.first[row]; i < sweep.first[row + 1]; ++i) {
      const dy = (heights[i] - place.y) / perPixel.y;
      const square = dx * dx + dy * dy;
      if (square > least) continue;
      least = square;
      best = { kind: 'dot', row, dot: i, value: sweep.values[row], height: heights[i] };
    }
  }
  return best && { ...best, distance: Math.sqrt(least) };
}

// The nearer node of the nearest piece of a line.
export function nearestNode(lines, place, perPixel, reach, shows) {
  let best = null, least = reach * reach;
  for (const line of lines) {
    if (!shows(line.kind)) continue;
    for (let i = 0; i < line.x.length; ++i) {
      const next = Math.min(i + 1, line.x.length - 1);
      const ax = (line.x[i] - place.x) / perPixel.x, ay = (line.y[i] - place.y) / perPixel.y;
      const bx = (line.x[next] - place.x) / perPixel.x, by = (line.y[next] - place.y) / perPixel.y;
      const lx = bx - ax, ly = by - ay;
      const length = lx * lx + ly * ly;
      const along = length > 0 ? Math.max(0, Math.min(1, -(ax * lx + ay * ly) / length)) : 0;
      const square = (ax + along * lx) ** 2 + (ay + along * ly) ** 2;
      if (!(square <= least)) continue;
      least = square;
      const node = along > 0.5 ? next : i;
      best = { kind: 'point', line, node, value: line.x[node], height: line.y[node] };
    }
  }
  return best && { ...best, distance: Math.sqrt(least) };
}

export function nearestSpecial(specials, key, place, perPixel, reach, shows) {
  let best = null, least = reach;
  for (const special of specials) {
    if (!shows(special.type)) continue;
    for (const height of special.y[key] ?? []) {
      const distance = Math.hypot((special.value - place.x) / perPixel.x, (height - place.y) / perPixel.y);
      if (distance > least) continue;
      least = distance;
      best = { kind: 'special', special, value: special.value, height, distance };
    }
  }
  return best;
}
