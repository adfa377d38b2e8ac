const fields = 6;

/**
 * Picks the particles that can be seen, one for each small square of the picture: without a
 * graphics card the number of points is what drawing takes time for, whatever their size.
 */
export class Foremost {
  constructor() {
    this.nearest = new Float32Array(0);
    this.chosen = new Uint32Array(0);
  }

  /**
   * Numbers of the foremost particles; the array is used again. `matrix` leads from the scene's frame
   * to clip space, `size` is that of a particle in px at a distance of 1 m.
   */
  of(particles, matrix, { width, height, size }) {
    const { first, second, share } = particles.shown;
    const [a, b] = particles.pair.places;
    const { ground } = particles.run;
    const e = matrix.elements;
    const side = this.#side(particles, e, size);
    const columns = Math.ceil(width / side), rows = Math.ceil(height / side);
    this.#clear(columns * rows);
    const { nearest, chosen } = this;
    const at = [0, 1, 2].map((k) => first.low[k] + share * (second.low[k] - first.low[k]));
    const fromA = [0, 1, 2].map((k) => ((1 - share) * (first.high[k] - first.low[k])) / 65535);
    const fromB = [0, 1, 2].map((k) => (share * (second.high[k] - second.low[k])) / 65535);
    const lastColumn = ground.columns - 1, lastRow = ground.rows - 1;
    for (let i = 0, k = 0; i < particles.count; ++i, k += fields) {
      const x = at[0] + fromA[0] * a[k] + fromB[0] * b[k];
      const y = at[1] + fromA[1] * a[k + 1] + fromB[1] * b[k + 1];
      const column = Math.min(Math.max(((x - ground.west) / ground.dx) | 0, 0), lastColumn);
      const row = Math.min(Math.max(((ground.north - y) / ground.dy) | 0, 0), lastRow);
      const z = ground.filled[row * ground.columns + column] +
        at[2] + fromA[2] * a[k + 2] + fromB[2] * b[k + 2];
      const w = e[3] * x + e[7] * y + e[11] * z + e[15];
      if (w <= 0) continue;
      const across = ((e[0] * x + e[4] * y + e[8] * z + e[12]) / w + 1) * 0.5 * width;
      const down = ((e[1] * x + e[5] * y + e[9] * z + e[13]) / w + 1) * 0.5 * height;
      if (!(across >= 0 && across < width && down >= 0 && down < height)) continue;
      const square = ((down / side) | 0) * columns + ((across / side) | 0);
      if (w >= nearest[square]) continue;
      nearest[square] = w;
      chosen[square] = i + 1;
    }
    let count = 0;
    for (let square = 0; square < columns * rows; ++square)
      if (chosen[square] > 0) chosen[count++] = chosen[square] - 1;
    return chosen.subarray(0, count);
  }

  /** Side of the squares, px: small beside the particles in the middle of the flow. */
  #side(particles, e, size) {
    const { low, high } = particles.shown.first;
    const [x, y] = [0, 1].map((k) => (low[k] + high[k]) / 2);
    const w = e[3] * x + e[7] * y + e[11] * particles.run.ground.height(x, y) + e[15];
    return w > 0 ? Math.min(Math.max(Math.round((0.4 * size) / w), 1), 8) : 1;
  }

  #clear(squares) {
    if (this.nearest.length < squares) {
      this.nearest = new Float32Array(squares);
      this.chosen = new Uint32Array(squares);
    }
    this.nearest.fill(Infinity, 0, squares);
    this.chosen.fill(0, 0, squares);
  }
}
