// The buttons, keys and the rectangle that zoom, beside the wheel and the dragging that ECharts sees
// to. Zooms are parts of the whole axes, in per cent.

export class ZoomTools {
  constructor(chart, root) {
    this.chart = chart;
    this.box = document.getElementById('zoom-box');
    const at = (id, action) => document.getElementById(id).addEventListener('click', action);
    at('zoom-in', () => this.scale(0.5));
    at('zoom-out', () => this.scale(2));
    at('zoom-reset', () => this.whole());
    at('zoom-box', () => this.select(this.box.getAttribute('aria-pressed') !== 'true'));
    root.addEventListener('keydown', (event) => {
      const action = {
        '+': () => this.scale(0.5), '=': () => this.scale(0.5), '-': () => this.scale(2),
        0: () => this.whole(),
      }[event.key];
      if (!action) return;
      action();
      event.preventDefault();
    });
    document.addEventListener('keydown', (event) => { if (event.key === 'Escape') this.select(false); });
    root.addEventListener('dblclick', () => this.whole());
    this.listenToRectangle(document.getElementById('select'), document.getElementById('rectangle'));
  }

  // Each way as parts of the axes in view, from the left and from below: [0, 1] is all of it. Of all
  // panels, or of one and those that are zoomed with it.
  zoomTo(parts, panel = null) {
    const isOf = ({ xAxisIndex, yAxisIndex }) => panel === null || [xAxisIndex ?? yAxisIndex].flat().includes(panel);
    const batch = this.chart.getOption().dataZoom.filter(isOf).map(({ id, start, end }) => {
      const [from, to] = parts[id.split(' ')[0]].map((part) => start + part * (end - start));
      const width = Math.min(100, to - from);
      const first = Math.max(0, Math.min(100 - width, from));
      return { dataZoomId: id, start: first, end: first + width };
    });
    this.chart.dispatchAction({ type: 'dataZoom', batch });
  }

  // About the middle of what is in view.
  scale(by) {
    const part = [0.5 - by / 2, 0.5 + by / 2];
    this.zoomTo({ across: part, upright: part });
  }

  whole() {
    this.chart.dispatchAction({
      type: 'dataZoom', batch: this.chart.getOption().dataZoom.map(({ id }) => ({ dataZoomId: id, start: 0, end: 100 })),
    });
  }

  // Whether dragging spans a rectangle to zoom into, or moves: a sheet over the chart takes it then.
  select(active) {
    this.box.setAttribute('aria-pressed', String(active));
    document.getElementById('select').hidden = !active;
    document.getElementById('rectangle').hidden = true;
  }

  listenToRectangle(sheet, rectangle) {
    let from = null;
    const place = (event) => {
      const box = sheet.getBoundingClientRect();
      return { x: event.clientX - box.x, y: event.clientY - box.y };
    };
    sheet.addEventListener('pointerdown', (event) => {
      from = place(event);
      sheet.setPointerCapture(event.pointerId);
    });
    sheet.addEventListener('pointermove', (event) => {
      if (!from) return;
      const to = place(event);
      rectangle.hidden = false;
      Object.assign(rectangle.style, {
        left: `${Math.min(from.x, to.x)}px`, top: `${Math.min(from.y, to.y)}px`,
        width: `${Math.abs(to.x - from.x)}px`, height: `${Math.abs(to.y - from.y)}px`,
      });
    });
    sheet.addEventListener('pointerup', (event) => {
      const start = from, end = place(event);
      from = null;
      if (!start || Math.abs(end.x - start.x) < 4 || Math.abs(end.y - start.y) < 4) return;
      const boxes = this.chart.getOption().grid.map((_, i) => this.chart.getModel().getComponent('grid', i).coordinateSystem.getRect());
      const panel = Math.max(0, boxes.findIndex((box) => box.contain(start.x, start.y)));
      const grid = boxes[panel];
      const part = (value) => Math.max(0, Math.min(1, value));
      const across = [start.x, end.x].map((x) => part((x - grid.x) / grid.width));
      const upright = [start.y, end.y].map((y) => part(1 - (y - grid.y) / grid.height));
      const sorted = (parts) => parts.sort((a, b) => a - b);
      this.select(false);
      this.zoomTo({ across: sorted(across), upright: sorted(upright) }, panel);
    });
  }
}
