// The picture as an image: title, what is drawn, what the legend or the bar of colours says of it.

const kEdge = 12, kGap = 8, kLine = 22;  // px

async function imageOf(svg) {
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(new XMLSerializer().serializeToString(svg))}`;
  await image.decode();
  return image;
}

// Entries with their place below the picture, in as many lines as they need.
function arranged(context, entries, width) {
  let x = kEdge, line = 0;
  return entries.map(({ title, image }) => {
    const long = image.width + 6 + context.measureText(title).width + 18;
    if (x > kEdge && x + long > width - kEdge) [x, line] = [kEdge, line + 1];
    const at = { title, image, x, line };
    x += long;
    return at;
  });
}

function drawBar(context, bar, top, ink) {
  const width = 350, height = 14, left = kEdge + context.measureText(bar.name).width + 14;
  context.fillText(bar.name, kEdge, top + height / 2);
  const fill = context.createLinearGradient(left, 0, left + width, 0);
  bar.colours.forEach((colour, i) => fill.addColorStop(i / (bar.colours.length - 1), colour));
  context.fillStyle = fill;
  context.fillRect(left, top, width, height);
  context.fillStyle = ink;
  context.textAlign = 'center';
  bar.tics.forEach((text, i) => context.fillText(text, left + (i / (bar.tics.length - 1)) * width, top + height + 12));
  context.textAlign = 'left';
}

// `under`: the canvas below the chart, or null; `bar`: { name, colours, tics } or null.
export async function pictureImage({ chart, under, theme, entries, bar }) {
  const ratio = window.devicePixelRatio || 1;
  const { paper, ink, faint } = theme.colours;
  const width = chart.getWidth(), height = chart.getHeight();
  const font = (size, weight = '') => `${weight} ${size}px system-ui, "DejaVu Sans", sans-serif`;
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  const swatches = await Promise.all(entries.map(async ({ title, swatch }) => ({ title, image: await imageOf(swatch(theme)) })));
  context.font = font(13);
  const legend = arranged(context, swatches, width);
  const top = kEdge + 2 * kLine, below = top + height + kGap;
  const lines = legend.length > 0 ? legend.at(-1).line + 1 : 0;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round((below + lines * kLine + (bar ? 2 * kLine : 0) + kEdge) * ratio);
  context.scale(ratio, ratio);
  context.fillStyle = paper;
  context.fillRect(0, 0, width, canvas.height);
  context.textBaseline = 'middle';
  context.fillStyle = ink;
  context.font = font(17, 'bold');
  context.fillText(document.getElementById('title').textContent, kEdge, kEdge + kLine / 2);
  context.fillStyle = faint;
  context.font = font(12);
  context.fillText(document.getElementById('subtitle').textContent, kEdge, kEdge + 1.5 * kLine);
  if (under && under.width > 0 && under.height > 0) context.drawImage(under, 0, top, width, height);
  context.drawImage(chart.renderToCanvas({ pixelRatio: ratio }), 0, top, width, height);
  context.fillStyle = ink;
  context.font = font(13);
  for (const { title, image, x, line } of legend) {
    const middle = below + (line + 0.5) * kLine;
    context.drawImage(image, x, middle - image.height / 2);
    context.fillText(title, x + image.width + 6, middle);
  }
  if (bar) drawBar(context, bar, below + lines * kLine + 4, ink);
  return canvas;
}
