// The part of axes that is in view.

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
