// A table of what a picture shows, as the text of a CSV file: a head with names and units, then rows
// that need not have all columns. No column is named twice.

function field(text) { return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text; }

// A number with so many digits, empty where there is none.
export function digits(value, count = 15) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(count))) : '';
}

export class CsvTable {
  // `columns`: those that come first.
  constructor(columns = []) {
    this.columns = new Map(columns.map((name, i) => [name, i]));
    this.rows = [];
  }

  column(name) {
    if (!this.columns.has(name)) this.columns.set(name, this.columns.size);
    return this.columns.get(name);
  }

  // `cells`: pairs of a column and its text.
  row(...cells) {
    const row = [];
    for (const [column, text] of cells) row[this.column(column)] = text;
    this.rows.push(row);
  }

  text() {
    const count = this.columns.size;
    const line = (cells) => Array.from({ length: count }, (_, i) => field(cells[i] ?? '')).join(',');
    return `${[line([...this.columns.keys()]), ...this.rows.map(line)].join('\n')}\n`;
  }
}
