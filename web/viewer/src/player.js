const rates = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];

/** The time that is shown, and its going on. */
export class Player {
  constructor(runs) {
    this.times = [...new Set(runs.flatMap((run) => run.times))].sort((a, b) => a - b);
    this.end = this.times.at(-1);
    this.rates = rates;
    // Half a minute for the whole run.
    this.rate = rates.find((rate) => this.end / rate <= 30) ?? rates.at(-1);
    this.time = 0;
    this.isPlaying = false;
    this.isSmooth = true;
  }

  /** Whether what is shown was filled in between two frames. */
  get isBetween() {
    return this.isSmooth && this.times.every((t) => Math.abs(t - this.time) > 1e-6 * this.end);
  }

  toggle() {
    this.isPlaying = !this.isPlaying;
    if (this.isPlaying && this.time >= this.end) this.time = 0;
  }

  set(time) {
    this.time = Math.min(Math.max(time, 0), this.end);
  }

  /** To the frame before or after. */
  step(direction) {
    this.isPlaying = false;
    const epsilon = 1e-6 * Math.max(this.end, 1e-9);
    const next = direction > 0
      ? this.times.find((t) => t > this.time + epsilon)
      : this.times.findLast((t) => t < this.time - epsilon);
    this.set(next ?? (direction > 0 ? this.end : 0));
  }

  /** Goes on by some real time, s; a pause of the browser is not caught up with. */
  advance(seconds) {
    if (!this.isPlaying) return;
    this.set(this.time + this.rate * Math.min(seconds, 0.25));
    if (this.time >= this.end) this.isPlaying = false;
  }
}
