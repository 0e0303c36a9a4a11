// The legend: a button for each type of what is shown, which hides it and shows it again.
import { element } from './format.js';
import { lookSwatch, specialLook } from './marks.js';

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

// Of a thing with a look of the program.
export function lookEntry(look, type = look.id) {
  return { type, title: look.title, swatch: (theme) => lookSwatch(look, theme) };
}

// Of a diagram: only what it has over its axes, and in panels below. What lies on top stands first.
export function diagramEntries({ looks, sweep }, { cloud, lines, marks }, strips) {
  const entries = [];
  if (cloud && sweep.wild.includes(0)) entries.push(lookEntry(looks.dots.periodic));
  if (cloud && sweep.wild.includes(1)) entries.push(lookEntry(looks.dots.wild));
  const drawn = new Set(lines.map((line) => line.kind));
  for (let kind = looks.lines.length; kind-- > 0;) if (drawn.has(kind)) entries.push(lookEntry(looks.lines[kind]));
  for (const type of new Set(marks.map(({ special }) => special.type))) entries.push(lookEntry(specialLook(looks, type), type));
  if (strips.length > 0) entries.push(lookEntry(looks.dots.lower));
  return entries;
}
