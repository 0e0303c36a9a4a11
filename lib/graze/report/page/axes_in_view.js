// The part of the first axes that is in view, which all pictures with a plane ask for.

// What it spans, as numbers along the axes divided by the factors, and where it is, px. Factors from SI
// to the axes' units give SI.
export function planeInView(chart, xFactor = 1, yFactor = 1) {
  const box = chart.getModel().getComponent('grid', 0).coordinateSystem.getRect();
  const [x0, y0] = chart.convertFromPixel({ gridIndex: 0 }, [box.x, box.y + box.height]);
  const [x1, y1] = chart.convertFromPixel({ gridIndex: 0 }, [box.x + box.width, box.y]);
  return {
    left: box.x, top: box.y, right: box.x + box.width, bottom: box.y + box.height,
    x: [x0 / xFactor, x1 / xFactor], y: [y0 / yFactor, y1 / yFactor],
  };
}

// Into an option that is about to be set anew: the zoom stays as it is.
export function keepZoom(chart, option) {
  const zoomed = chart.getOption()?.dataZoom;
  for (const part of option.dataZoom) {
    const last = zoomed?.find(({ id }) => id === part.id);
    if (last) Object.assign(part, { start: last.start, end: last.end });
  }
}

// The part of a range that a zoom ({ id, start, end } of an option's dataZoom) leaves in view.
export function partInView([low, high], zoom) {
  const at = (percent) => low + ((percent ?? 0) / 100) * (high - low);
  return [at(zoom?.start ?? 0), at(zoom?.end ?? 100)];
}
