// The column beside the picture: its head, the command that makes what it tells of again, and its end.
import { element } from './format.js';

const kPart = { series: '#orbit-series', portrait: '#orbit-portrait', circle: '#orbit-circle' };

export class Panel {
  // `charts`: which of 'series', 'portrait', 'circle' it has; `resized` is called when the picture
  // gets or loses its place; `closed` when the reader closed it.
  constructor(charts, resized, closed = () => {}) {
    Object.assign(this, { resized, closed });
    this.root = document.getElementById('orbit');
    for (const [name, selector] of Object.entries(kPart)) document.querySelector(selector).hidden = !charts.includes(name);
    document.getElementById('orbit-close').addEventListener('click', () => this.close());
    this.root.addEventListener('keydown', (event) => { if (event.key === 'Escape') this.close(); });
    document.getElementById('orbit-copy').addEventListener('click', () => this.copy());
  }

  get isOpen() { return !this.root.hidden; }

  // Whether it was closed before.
  open(title, facts) {
    const opened = this.root.hidden;
    this.root.hidden = false;
    document.getElementById('orbit-title').textContent = title;
    document.getElementById('orbit-facts').textContent = facts.join(' · ');
    if (opened) this.resized();
    return opened;
  }

  // For the keys, once all is in it.
  focus() { document.getElementById('orbit-close').focus({ preventScroll: true }); }

  // A column that is always there.
  keepOpen() { document.getElementById('orbit-close').hidden = true; }

  close() {
    if (document.getElementById('orbit-close').hidden) return;
    this.root.hidden = true;
    this.closed();
    this.resized();
    document.getElementById('chart').focus({ preventScroll: true });
  }

  // Rows of name and value.
  tellNumbers(rows) {
    document.getElementById('orbit-numbers').replaceChildren(...(rows.length === 0 ? [] : [element('table', { class: 'list' },
      element('tbody', {}, ...rows.map(([name, value]) => element('tr', {}, element('th', { scope: 'row' }, name), element('td', {}, value)))))]));
  }

  tellRemark(...sentences) {
    document.getElementById('orbit-remark').textContent = sentences.filter(Boolean).join(' ');
  }

  // No line ends within an option, which would look like two.
  tellCommand(text) {
    document.getElementById('orbit-command').replaceChildren(
      ...text.split(' ').flatMap((word, i) => [i > 0 ? ' ' : '', element('span', {}, word)]));
  }

  // Files opened from a disk have no clipboard in every browser: then the text is selected.
  async copy() {
    const text = document.getElementById('orbit-command');
    const button = document.getElementById('orbit-copy');
    try {
      await navigator.clipboard.writeText(text.textContent);
      button.textContent = 'Copied';
    } catch {
      getSelection().selectAllChildren(text);
      button.textContent = 'Selected';
    }
    setTimeout(() => { button.textContent = 'Copy'; }, 1500);
  }
}
