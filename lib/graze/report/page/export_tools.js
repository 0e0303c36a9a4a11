// The buttons that save what is shown: the picture as PNG, its numbers as CSV. Nothing leaves the
// browser: a file is a Blob behind a link.
import { element } from './format.js';
import { pictureImage } from './picture_image.js';

// "sweep.csv" of a page named sweep.html.
function fileName(ending) {
  const page = decodeURIComponent(location.pathname.split('/').at(-1)).replace(/\.html?$/i, '');
  return `${page || 'graze'}.${ending}`;
}

function save(blob, name) {
  const link = element('a', { href: URL.createObjectURL(blob), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

export class ExportTools {
  // `under`: the canvas below the chart, or null; `bar()`: the bar of colours that stands for the
  // legend, or null; `table()`: a CsvTable.
  constructor({ theme, chart, legend, under = null, bar = () => null, table }) {
    document.getElementById('save-png').addEventListener('click', async () => {
      const canvas = await pictureImage({ chart, under, theme, entries: legend.shown, bar: bar() });
      canvas.toBlob((blob) => save(blob, fileName('png')), 'image/png');
    });
    // With the mark that tells spreadsheets of UTF-8.
    document.getElementById('save-csv').addEventListener('click', () =>
      save(new Blob(['\ufeff', table().text()], { type: 'text/csv;charset=utf-8' }), fileName('csv')));
  }
}
