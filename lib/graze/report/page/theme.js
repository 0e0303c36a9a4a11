// Light and dark. The colours are those of the pictures, by M. Okabe and K. Ito (Color Universal
// Design, 2008); on dark ground blue is lighter, as it would be hard to see, and black is white;
// in maps what is dark for never repeating and pale for no motion changes places.
const kLight = {
  blue: '#0072B2', vermillion: '#D55E00', green: '#009E73', black: '#000000', orange: '#E69F00',
  sky: '#56B4E9', purple: '#CC79A7', grey: '#999999',
  paper: '#FFFFFF', ink: '#1B1B1B', faint: '#5C5C5C', line: '#DADADA', stop: '#DDDDDD',
  stuck: '#F8DA98', yellow: '#F0E442', wild: '#444444', other: '#BBBBBB', none: '#EEEEEE',
};
const kDark = {
  ...kLight, blue: '#3D9BE0', vermillion: '#F0803C', black: '#F2F2F2', grey: '#8A8F96',
  paper: '#15181C', ink: '#E8E8E8', faint: '#A8ADB3', line: '#333A42', stop: '#3A4048',
  stuck: '#5C4A1C', wild: '#D9D9D9', other: '#6D737B', none: '#262B31',
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

  // A colour of the pictures as it is on this ground.
  shade(colour) {
    const name = Object.keys(kLight).find((known) => kLight[known] === colour);
    return name ? this.colours[name] : colour;
  }

  onChange(listener) { this.listeners.push(listener); }
}
