// The button that shows the names of marks in the picture, and hides them again.

export class LabelTool {
  // `has`: whether the picture has any.
  constructor(has, changed) {
    this.button = document.getElementById('labels');
    this.button.hidden = !has;
    this.button.addEventListener('click', () => {
      this.button.setAttribute('aria-pressed', String(!this.on));
      changed();
    });
  }

  get on() { return this.button.getAttribute('aria-pressed') === 'true'; }
}
