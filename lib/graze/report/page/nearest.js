// What of a picture is nearest to a place, with its numbers along the axes and the distance in pixels;
// null where nothing is within reach.

// The point of the lines of a panel (placed() in things.js) that is nearest to a pixel, as { line, node }.
// `plane`: where the panel is, px, and the ranges { x, y } that it spans. Marks are few, and lie on all
// else; so does a line on dots.
export function nearestInPanel(lines, plane, [px, py], reach) {
  const perPixel = {
    x: (plane.x[1] - plane.x[0]) / (plane.right - plane.left), y: (plane.y[1] - plane.y[0]) / (plane.bottom - plane.top),
  };
  const place = { x: plane.x[0] + (px - plane.left) * perPixel.x, y: plane.y[1] - (py - plane.top) * perPixel.y };
  const of = (is) => lines.filter(({ series }) => is(series));
  const mark = nearestPoint(of(({ line, dots }) => !line && !dots), place, perPixel, reach);
  if (mark) return mark;
  const node = nearestNode(of(({ line }) => line), place, perPixel, reach);
  const dot = nearestPoint(of(({ dots }) => dots), place, perPixel, reach);
  return node && !(dot && dot.distance + 2 < node.distance) ? node : dot;
}

// `place`: numbers along the axes { x, y }; `perPixel`: of these per pixel { x, y }.
function nearestPoint(lines, place, perPixel, reach) {
  let best = null, least = reach * reach;
  for (const line of lines)
    for (let i = 0; i < line.x.length; ++i) {
      const dx = (line.x[i] - place.x) / perPixel.x;
      if (!(dx * dx <= least)) continue;
      const dy = (line.y[i] - place.y) / perPixel.y;
      const square = dx * dx + dy * dy;
      if (!(square <= least)) continue;
      least = square;
      best = { line, node: i };
    }
  return best && { ...best, distance: Math.sqrt(least) };
}

// The nearer node of the nearest piece of a line.
function nearestNode(lines, place, perPixel, reach) {
  let best = null, least = reach * reach;
  for (const line of lines) {
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
      best = { line, node };
    }
  }
  return best && { ...best, distance: Math.sqrt(least) };
}
