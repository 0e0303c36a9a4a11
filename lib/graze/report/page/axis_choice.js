// The choice of what stands along the axes of a diagram, and on which scale. A quantity stands on one
// of them: chosen for one, it leaves its place on the other to what was there.
import { AxisScale, kScales } from './axis_scale.js';

export class AxisChoice {
  // `quantities`: the observables and the parameter; `changed` is called after a choice.
  constructor(quantities, { x, y }, changed) {
    Object.assign(this, { quantities, changed });
    this.scales = { x: new AxisScale(x), y: new AxisScale(y) };
    this.selects = { y: document.getElementById('observable'), x: document.getElementById('abscissa') };
    this.kinds = { y: document.getElementById('observable-scale'), x: document.getElementById('abscissa-scale') };
    for (const name of ['x', 'y']) {
      quantities.forEach((quantity, i) => this.selects[name].add(new Option(quantity.name, quantity.key ?? String(i))));
      for (const [kind, words] of Object.entries(kScales)) this.kinds[name].add(new Option(words, kind));
      this.selects[name].addEventListener('change', () => this.choose(name, quantities[this.selects[name].selectedIndex]));
      this.kinds[name].addEventListener('change', () => this.scale(name, this.kinds[name].value));
    }
    document.getElementById('abscissae').hidden = false;
    for (const kind of Object.values(this.kinds)) kind.hidden = false;
    this.tell();
  }

  choose(name, quantity) {
    const other = name === 'x' ? 'y' : 'x';
    if (this.scales[other].quantity === quantity) this.scales[other] = this.scales[name];
    this.scales[name] = new AxisScale(quantity, this.kindFor(quantity, this.scales[name].kind));
    this.tell();
    this.changed();
  }

  scale(name, kind) {
    this.scales[name] = new AxisScale(this.scales[name].quantity, kind);
    this.tell();
    this.changed();
  }

  // What is nowhere above zero has no logarithm.
  kindFor(quantity, kind) { return kind === 'log' && !quantity.has_logarithm ? 'linear' : kind; }

  tell() {
    for (const name of ['x', 'y']) {
      const { quantity, kind } = this.scales[name];
      this.selects[name].selectedIndex = this.quantities.indexOf(quantity);
      this.kinds[name].value = kind;
      this.kinds[name].querySelector('[value=log]').disabled = !quantity.has_logarithm;
    }
  }
}
