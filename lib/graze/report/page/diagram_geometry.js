// Where the things of a diagram lie over two of its quantities: lines of branches, special points and
// the dots of a sweep, as numbers along the axes.
//
// A quantity is the parameter, or a number that a motion has one of, or one of each of its impacts or
// periods; the latter meet by their order in the motion.

const kMostDecades = 6;  // of a logarithmic axis: below lies where speeds vanish

export class DiagramGeometry {
  // `x`, `y`: an AxisScale each.
  constructor(view, x, y) {
    Object.assign(this, { view, x, y });
    this.lines = this.placedLines();
    this.marks = this.placedMarks();
    this.cloud = this.placedDots();
  }

  isParameter(quantity) { return quantity === this.view.parameter; }
  isOfMotion(quantity) { return this.isParameter(quantity) || quantity.of_motion; }

  // The quantity whose values tell how many there are of each motion; null if every motion has one.
  get counted() {
    return [this.y.quantity, this.x.quantity].find((quantity) => !this.isOfMotion(quantity)) ?? null;
  }

  // SI, of a branch's point (special points: -1 - index); NaN where there is none.
  valueAt(quantity, branch, point, index) {
    const { special, branches, values } = this.view;
    if (point === undefined) return NaN;
    if (this.isParameter(quantity)) return point < 0 ? special[-1 - point].value : branches[branch].value[point];
    if (point < 0) return special[-1 - point].y[quantity.key]?.[quantity.of_motion ? 0 : index] ?? NaN;
    const list = values[quantity.key]?.[branch];
    if (!list) return NaN;
    if (quantity.of_motion) return list.of[point];
    const at = list.first[point] + index;
    return at < list.first[point + 1] ? list.of[at] : NaN;
  }

  placedLines() {
    const { lines } = this.view;
    return ((this.counted ? lines?.[this.counted.key] : lines?.motion) ?? []).map((line) => {
      const count = line.point.length;
      const [x, y] = [this.x, this.y].map((scale) => Float64Array.from({ length: count },
        (_, i) => scale.of(this.valueAt(scale.quantity, line.branch, line.point[i], line.index?.[i] ?? 0))));
      return { ...line, x, y, ends: this.ends(line) };
    });
  }

  // Where an angle passes its whole turn between a node and the next, a line ends: 1, else 0.
  ends(line) {
    const turning = [this.x, this.y].map(({ quantity }) => quantity).filter(({ turn }) => turn !== undefined);
    const at = (quantity, i) => this.valueAt(quantity, line.branch, line.point[i], line.index?.[i] ?? 0);
    return Uint8Array.from({ length: line.point.length },
      (_, i) => (turning.some((quantity) => Math.abs(at(quantity, i + 1) - at(quantity, i)) > quantity.turn / 2) ? 1 : 0));
  }

  placedMarks() {
    const marks = [];
    (this.view.special ?? []).forEach((special, i) => {
      const count = Math.min(special.marks, this.counted ? special.y[this.counted.key]?.length ?? 0 : 1);
      for (let index = 0; index < count; ++index) {
        const [x, y] = [this.x, this.y].map((scale) => scale.of(this.valueAt(scale.quantity, 0, -1 - i, index)));
        if (Number.isFinite(x) && Number.isFinite(y)) marks.push({ special, index, x, y });
      }
    });
    return marks;
  }

  // SI, of a dot of the sweep: row and its place among all dots.
  dotValue(quantity, row, dot) {
    const { sweep } = this.view;
    if (this.isParameter(quantity)) return sweep.values[row];
    const values = sweep.dots[quantity.key];
    return values === undefined ? NaN : values[quantity.of_motion ? row : dot];
  }

  // Of every dot its place, row and number; null where the sweep does not have these quantities.
  placedDots() {
    const { sweep } = this.view;
    const has = ({ quantity }) => this.isParameter(quantity) || sweep.dots[quantity.key] !== undefined;
    if (!sweep || !has(this.x) || !has(this.y)) return null;
    const rows = sweep.values.length;
    const count = this.counted ? sweep.first[rows] : rows;
    const cloud = { x: new Float64Array(count), y: new Float64Array(count), row: new Int32Array(count), dot: new Int32Array(count) };
    let at = 0;
    for (let row = 0; row < rows; ++row) {
      const [from, to] = this.counted ? [sweep.first[row], sweep.first[row + 1]] : [sweep.first[row], sweep.first[row] + 1];
      for (let dot = from; dot < to; ++dot, ++at) {
        cloud.x[at] = this.x.of(this.dotValue(this.x.quantity, row, dot));
        cloud.y[at] = this.y.of(this.dotValue(this.y.quantity, row, dot));
        cloud.row[at] = row;
        cloud.dot[at] = dot;
      }
    }
    return cloud;
  }

  // What an axis spans, as numbers along it; null where nothing of it can be drawn.
  range(name) {
    const { quantity, kind } = this[name];
    const whole = this.isParameter(quantity)
      ? [Math.min(quantity.from, quantity.to), Math.max(quantity.from, quantity.to)] : [quantity.low, quantity.high];
    const [low, high] = whole.map((value) => this[name].of(value));
    if (kind === 'linear') return [low, high];
    let least = Infinity, most = -Infinity;
    for (const { [name]: values } of [...this.lines, ...(this.cloud ? [this.cloud] : [])])
      for (const value of values) {
        if (value < least) least = value;
        if (value > most) most = value;
      }
    if (!(least <= most)) return null;
    if (quantity.low >= 0 && high < most) most = high;
    if (this.isParameter(quantity) && Number.isFinite(low)) return [low, high];
    const decade = kind === 'log' ? 1 : 20;
    least = Math.max(least, most - kMostDecades * decade);
    const room = Math.max(0.04 * (most - least), 0.02 * decade);
    return [least - room, most + room];
  }
}
