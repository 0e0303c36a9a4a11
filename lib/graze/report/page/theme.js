// Light and dark. What a kind of thing looks like on light ground the program says (view.looks); on
// dark ground colours that would be hard to see are lighter and black is white, and in maps what is
// dark for never repeating and pale for no motion change places.
const kLight = { paper: '#FFFFFF', ink: '#1B1B1B', faint: '#5C5C5C', line: '#DADADA' };
const kDark = { paper: '#15181C', ink: '#E8E8E8', faint: '#A8ADB3', line: '#333A42' };

const kOnDark = {
  '#000000': '#F2F2F2', '#FFFFFF': '#15181C', '#0072B2': '#3D9BE0', '#D55E00': '#F0803C', '#AA3377': '#DB77AE',
  '#332288': '#A093F2', '#999999': '#8A8F96', '#DDDDDD': '#3A4048', '#F2C35E': '#5C4A1C', '#5A5A5A': '#D9D9D9',
  '#BBBBBB': '#6D737B', '#E8E8E8': '#262B31',
};

export class Theme {
  constructor(button) {
    const system = window.matchMedia('(prefers-color-scheme: dark)');
    this.listeners = [];
    this.button = button;
    this.set(system.matches);
    system.addEventListener('change', () => this.set(system.matches));
    button.addEventListener('click', () => this.set(!this.dark));
  }

  set(dark) {
    this.dark = dark;
    this.colours = dark ? kDark : kLight;
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    this.button.textContent = dark ? 'Light' : 'Dark';
    this.button.setAttribute('aria-label', `Change to ${dark ? 'light' : 'dark'} colours`);
    for (const listener of this.listeners) listener();
  }

  // A colour of the program, "#0072B2", as it is on this ground.
  shade(colour) { return this.dark ? kOnDark[colour] ?? colour : colour; }

  onChange(listener) { this.listeners.push(listener); }
}
