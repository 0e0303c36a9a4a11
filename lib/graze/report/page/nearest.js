// What of a picture is nearest to a place, as { kind, .. , x, y, distance } with its numbers along the
// axes and the distance in pixels; null where nothing is within reach.

// `place`: numbers along the axes { x, y }; `perPixel`: of these per pixel { x, y }.
export function nearestDot(cloud, wild, place, perPixel, reach, shows) {
  let best = -1, least = reach * reach;
  const shown = [shows('periodic'), shows('wild')];
  for (let i = 0; i < cloud.x.length; ++i) {
    const dx = (cloud.x[i] - place.x) / perPixel.x;
    if (!(dx * dx <= least)) continue;
    const dy = (cloud.y[i] - place.y) / perPixel.y;
    const square = dx * dx + dy * dy;
    if (!(square <= least) || !shown[wild[cloud.row[i]]]) continue;
    least = square;
    best = i;
  }
  if (best < 0) return null;
  return { kind: 'dot', row: cloud.row[best], dot: cloud.dot[best], x: cloud.x[best], y: cloud.y[best], distance: Math.sqrt(least) };
}

// The nearer node of the nearest piece of a line.
export function nearestNode(lines, place, perPixel, reach, shows) {
  let best = null, least = reach * reach;
  for (const line of lines) {
    if (!shows(line)) continue;
    for (let i = 0; i < line.x.length; ++i) {
      const next = !line.ends?.[i] && Number.isFinite(line.x[i + 1]) && Number.isFinite(line.y[i + 1]) ? i + 1 : i;
      const ax = (line.x[i] - place.x) / perPixel.x, ay = (line.y[i] - place.y) / perPixel.y;
      const bx = (line.x[next] - place.x) / perPixel.x, by = (line.y[next] - place.y) / perPixel.y;
      const lx = bx - ax, ly = by - ay;
      const length = lx * lx + ly * ly;
      const along = length > 0 ? Math.max(0, Math.min(1, -(ax * lx + ay * ly) / length)) : 0;
      const square = (ax + along * lx) ** 2 + (ay + along * ly) ** 2;
      if (!(square <= least)) continue;
      least = square;
      const node = along > 0.5 ? next : i;
      best = { kind: 'point', line, node, x: line.x[node], y: line.y[node] };
    }
  }
  return best && { ...best, distance: Math.sqrt(least) };
}

// `marks`: with their place { x, y } each.
export function nearestMark(marks, place, perPixel, reach, shows) {
  let best = null, least = reach;
  for (const mark of marks) {
    if (!shows(mark)) continue;
    const distance = Math.hypot((mark.x - place.x) / perPixel.x, (mark.y - place.y) / perPixel.y);
    if (distance > least) continue;
    least = distance;
    best = { kind: 'special', ...mark, distance };
  }
  return best;
}
