import { bytesOf } from './load_script.js';

const noData = 65535;

/**
 * Heights at the centres of square cells, row by row from the north-west. Places are in the
 * scene's frame: metres east and north of its origin.
 */
export class Ground {
  constructor(raw) {
    Object.assign(this, raw);
    const numbers = new Uint16Array(bytesOf(raw.heights).buffer);
    this.heights = new Float32Array(numbers.length);
    const unit = (raw.high - raw.low) / (noData - 1);
    for (let i = 0; i < numbers.length; ++i)
      this.heights[i] = numbers[i] === noData ? NaN : raw.low + unit * numbers[i];
    this.filled = this.heights.map((z) => (Number.isNaN(z) ? raw.low : z));
  }

  x(column) {
    return this.west + (column + 0.5) * this.dx;
  }

  y(row) {
    return this.north - (row + 0.5) * this.dy;
  }

  get east() {
    return this.west + this.columns * this.dx;
  }

  get south() {
    return this.north - this.rows * this.dy;
  }

  get centre() {
    return [(this.west + this.east) / 2, (this.south + this.north) / 2];
  }

  /** Between four centres; outside the map that of its edge. The shader of the flow does the same. */
  height(x, y) {
    const { u, v, k } = this.#square(x, y);
    const h = this.filled;
    const upper = h[k] + u * (h[k + 1] - h[k]);
    const lower = h[k + this.columns] + u * (h[k + this.columns + 1] - h[k + this.columns]);
    return upper + v * (lower - upper);
  }

  has(x, y) {
    if (x < this.x(0) || x > this.x(this.columns - 1)) return false;
    if (y > this.y(0) || y < this.y(this.rows - 1)) return false;
    const { k } = this.#square(x, y);
    return [k, k + 1, k + this.columns, k + this.columns + 1].every(
      (cell) => !Number.isNaN(this.heights[cell]));
  }

  #square(x, y) {
    const across = Math.min(Math.max((x - this.x(0)) / this.dx, 0), this.columns - 1);
    const down = Math.min(Math.max((this.y(0) - y) / this.dy, 0), this.rows - 1);
    const column = Math.min(Math.floor(across), this.columns - 2);
    const row = Math.min(Math.floor(down), this.rows - 2);
    return { u: across - column, v: down - row, k: row * this.columns + column };
  }
}
