// The box beside the pointer that tells the values of what is under it, and the ring around that.
import { element } from './format.js';

export class Hover {
  constructor(box, ring) {
    Object.assign(this, { box, ring });
  }

  // `at`: pixels within the stage; `lines`: pairs of name and value.
  show(at, title, lines, remark) {
    const rows = lines.map(([name, value]) => element('tr', {}, element('td', {}, name), element('td', {}, value)));
    this.box.replaceChildren(element('b', {}, title), element('table', {}, ...rows), remark);
    this.box.hidden = this.ring.hidden = false;
    this.ring.style.left = `${at.x}px`;
    this.ring.style.top = `${at.y}px`;
    const stage = this.box.parentElement;
    const left = at.x + 18 + this.box.offsetWidth > stage.clientWidth;
    const up = at.y + 14 + this.box.offsetHeight > stage.clientHeight;
    this.box.style.left = `${Math.max(0, left ? at.x - 14 - this.box.offsetWidth : at.x + 14)}px`;
    this.box.style.top = `${Math.max(0, up ? at.y - 10 - this.box.offsetHeight : at.y + 10)}px`;
  }

  hide() {
    this.box.hidden = this.ring.hidden = true;
  }
}
