// The legend: a button for each type of what is shown, which hides it and shows it again.
import { element } from './format.js';
import { dotSwatch, kDotKinds, kLineKinds, kLowerKind, lineSwatch, markOf, markSwatch } from './marks.js';

export class Legend {
  // `entries`: { type, title, swatch(colours) }; they may be others when it is drawn again. `changed`
  // is called after a click.
  constructor(root, theme, entries, changed) {
    Object.assign(this, { root, theme, entries, changed });
    this.hidden = new Set();
    this.draw();
  }

  shows(type) { return !this.hidden.has(type); }

  draw() {
    this.root.replaceChildren(...this.entries.map((entry) => element('button', {
      type: 'button', 'data-type': entry.type, 'aria-pressed': String(this.shows(entry.type)),
      onclick: (event) => this.toggle(entry.type, event.currentTarget),
    }, entry.swatch(this.theme.colours), entry.title)));
  }

  toggle(type, button) {
    if (!this.hidden.delete(type)) this.hidden.add(type);
    button.setAttribute('aria-pressed', String(this.shows(type)));
    this.changed();
  }
}

// Of a picture over a parameter: only what it has.
export function diagramEntries(view) {
  const entries = [];
  const wild = view.sweep ? view.sweep.wild : new Uint8Array();
  const crowd = (kind, found) => {
    if (found) entries.push({ ...kind, swatch: (colours) => dotSwatch(kind, colours) });
  };
  crowd(kDotKinds[0], wild.includes(0));
  crowd(kDotKinds[1], wild.includes(1));
  const drawn = new Set(Object.values(view.lines).flat().map((line) => line.kind));
  for (let kind = kLineKinds.length; kind-- > 0;)
    if (drawn.has(kind))
      entries.push({ ...kLineKinds[kind], swatch: (colours) => lineSwatch(kLineKinds[kind], colours) });
  for (const type of new Set(view.special.map((special) => special.type))) {
    const mark = markOf(type);
    entries.push({ type, title: mark.title, swatch: (colours) => markSwatch(mark, colours) });
  }
  if (view.strips.length > 0) entries.push({ ...kLowerKind, swatch: (colours) => dotSwatch(kLowerKind, colours) });
  return entries;
}
