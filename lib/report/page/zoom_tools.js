// The buttons and keys that zoom, beside the wheel and the dragging that ECharts sees to.

export class ZoomTools {
  constructor(chart, root) {
    this.chart = chart;
    this.box = document.getElementById('zoom-box');
    const at = (id, action) => document.getElementById(id).addEventListener('click', action);
    at('zoom-in', () => this.scale(0.5));
    at('zoom-out', () => this.scale(2));
    at('zoom-reset', () => this.whole());
    at('zoom-box', () => this.select(this.box.getAttribute('aria-pressed') !== 'true'));
    chart.on('datazoom', (event) => { if (event.batch?.[0]?.startValue !== undefined) this.select(false); });
    root.addEventListener('keydown', (event) => {
      const action = {
        '+': () => this.scale(0.5), '=': () => this.scale(0.5), '-': () => this.scale(2),
        0: () => this.whole(), Escape: () => this.select(false),
      }[event.key];
      if (!action) return;
      action();
      event.preventDefault();
    });
    root.addEventListener('dblclick', () => this.whole());
  }

  // About the middle of what is in view.
  scale(by) {
    const batch = this.chart.getOption().dataZoom
      .filter((part) => part.id === 'across' || part.id === 'upright').map((part) => {
        const middle = (part.start + part.end) / 2;
        const half = Math.min(50, ((part.end - part.start) / 2) * by);
        const start = Math.max(0, Math.min(100 - 2 * half, middle - half));
        return { dataZoomId: part.id, start, end: start + 2 * half };
      });
    this.chart.dispatchAction({ type: 'dataZoom', batch });
  }

  whole() {
    this.chart.dispatchAction({
      type: 'dataZoom', batch: ['across', 'upright'].map((dataZoomId) => ({ dataZoomId, start: 0, end: 100 })),
    });
  }

  // Whether dragging spans a rectangle to zoom into, or moves.
  select(active) {
    this.box.setAttribute('aria-pressed', String(active));
    this.chart.dispatchAction({ type: 'takeGlobalCursor', key: 'dataZoomSelect', dataZoomSelectActive: active });
  }
}
