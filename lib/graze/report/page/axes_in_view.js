// The part of the first axes that is in view, which all pictures with a plane ask for.

// SI, and where it is, px. `xFactor`, `yFactor`: from SI to the axes' units.
export function planeInView(chart, xFactor, yFactor) {
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
