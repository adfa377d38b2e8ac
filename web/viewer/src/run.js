import { Ground } from './ground.js';
import { bytesOf, loadScript } from './load_script.js';

const format = 1; // view_format of the program
const keptBytes = 400e6;
const noValues = [0, 0, 0, 0, 0, 0];

/** A run: its scene and its frames, which are loaded when they are wanted. */
export class Run {
  constructor(base, scene) {
    if (scene.format !== format) throw new Error('format');
    this.base = base;
    this.scene = scene;
    this.ground = new Ground(scene.ground);
    this.times = scene.frames.map(([, time]) => time);
    this.frames = new Map(); // place in the list -> frame, or null while it is loaded
    this.onFrame = () => {};
    this.onMissing = () => {};
  }

  static async load(base) {
    return new Run(base, await loadScript(`${base}scene.js`));
  }

  get end() {
    return this.times.at(-1);
  }

  /** The frame at a place of the list, if it is there; else it is asked for. */
  frame(k) {
    if (!this.frames.has(k)) this.#load(k);
    return this.frames.get(k);
  }

  /**
   * The frames around a time and where it lies between them: the same frame twice on a frame, null
   * for one that is still being loaded.
   */
  around(time, isSmooth) {
    let k = this.times.findLastIndex((t) => t <= time + 1e-9);
    k = Math.max(k, 0);
    const next = Math.min(k + 1, this.times.length - 1);
    const gap = this.times[next] - this.times[k];
    const share = gap > 0 ? Math.min(Math.max((time - this.times[k]) / gap, 0), 1) : 0;
    if (!isSmooth || share < 1e-6) {
      const nearest = !isSmooth && share > 0.5 ? next : k;
      const frame = this.frame(nearest);
      return { first: frame, second: frame, share: 0 };
    }
    return { first: this.frame(k), second: this.frame(next), share };
  }

  /** Asks for the frames that come after a time. */
  lookAhead(time, count) {
    const k = this.times.findLastIndex((t) => t <= time + 1e-9);
    for (let next = k + 1; next <= Math.min(k + count, this.times.length - 1); ++next)
      this.frame(next);
  }

  async whenLoaded(k) {
    while (!this.frame(k)) await new Promise((resolve) => { setTimeout(resolve, 10); });
    return this.frames.get(k);
  }

  async #load(k) {
    this.frames.set(k, null);
    const [number] = this.scene.frames[k];
    const file = `frame_${String(number).padStart(5, '0')}.js`;
    let raw = { count: 0, low: noValues, high: noValues, ids: '', values: '' };
    try {
      raw = await loadScript(this.base + file);
    } catch {
      this.onMissing(this.base + file);
    }
    this.frames.set(k, {
      place: k,
      time: this.times[k],
      count: raw.count,
      low: raw.low,
      high: raw.high,
      ids: raw.ids ? new Uint32Array(bytesOf(raw.ids).buffer) : null,
      values: new Uint16Array(bytesOf(raw.values).buffer),
    });
    this.#forget(k);
    this.onFrame();
  }

  /** Drops the frames that are farthest from the newest when they take too much memory. */
  #forget(newest) {
    const loaded = [...this.frames].filter(([, frame]) => frame);
    let bytes = loaded.reduce((sum, [, frame]) => sum + frame.values.byteLength, 0);
    loaded.sort(([a], [b]) => Math.abs(b - newest) - Math.abs(a - newest));
    for (const [k, frame] of loaded) {
      if (bytes < keptBytes || Math.abs(k - newest) < 3) return;
      this.frames.delete(k);
      bytes -= frame.values.byteLength;
    }
  }
}
