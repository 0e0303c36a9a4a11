// The legend: a button for each type of what is shown, which hides it and shows it again.
import { element } from './format.js';
import { cellSwatch, lookSwatch } from './marks.js';

export class Legend {
  // `entries`: { type, title, swatch(theme) }; they may be others when it is drawn again. `changed` is
  // called after a click.
  constructor(root, theme, entries, changed) {
    Object.assign(this, { root, theme, entries, changed });
    this.hidden = new Set();
    this.draw();
  }

  shows(type) { return !this.hidden.has(type); }

  // Those that are switched on.
  get shown() { return this.entries.filter(({ type }) => this.shows(type)); }

  draw() {
    this.root.hidden = this.entries.length === 0;
    this.root.replaceChildren(...this.entries.map((entry) => element('button', {
      type: 'button', 'data-type': entry.type, 'aria-pressed': String(this.shows(entry.type)),
      onclick: (event) => this.toggle(entry.type, event.currentTarget),
    }, entry.swatch(this.theme), entry.title)));
  }

  toggle(type, button) {
    if (!this.hidden.delete(type)) this.hidden.add(type);
    button.setAttribute('aria-pressed', String(this.shows(type)));
    this.changed();
  }
}

// Of a chart one for each title, as it looks where it comes first. `order`: titles, which those not among
// them come before; `grounds`: of cells.
export function chartEntries(drawn, order, grounds) {
  const entries = new Map();
  const add = (title, swatch) => { if (title && !entries.has(title)) entries.set(title, { type: title, title, swatch }); };
  for (const { title, colour } of grounds) add(title, (theme) => cellSwatch(theme.shade(colour)));
  for (const { panel, lines } of drawn) {
    for (const { series: { title, look, line, marks } } of lines) add(title, (theme) => lookSwatch(look, theme, { line, marks }));
    for (const { title, colour } of panel.fills) add(title, (theme) => cellSwatch(theme.shade(colour)));
  }
  return [...entries.values()].sort((a, b) => order.indexOf(a.title) - order.indexOf(b.title));
}
