import { Vector3 } from 'three';

import { Controls } from './controls.js';
import { inLanguage } from './dom.js';
import { Labels } from './labels.js';
import { Legend } from './legend.js';
import { Player } from './player.js';
import { pick } from './probe.js';
import { quantities } from './quantities.js';
import { savePicture } from './screenshot.js';
import { Stage } from './stage.js';
import { text } from './text.js';
import { ValuesBox } from './values_box.js';

/** The page: runs, picture, time and what the user does with them. */
export class Viewer {
  constructor(runs, holder) {
    this.runs = runs;
    this.stage = new Stage(holder, runs);
    this.player = new Player(runs);
    this.legend = new Legend(runs);
    this.labels = new Labels(holder, this.stage);
    this.values = new ValuesBox(this.stage, () => this.labels.mark(null));
    this.controls = new Controls(this);
    this.stage.onDraw = () => this.labels.update();
    for (const run of runs) run.onFrame = () => this.refresh();
    this.stage.canvas.setAttribute('role', 'img');
    this.stage.canvas.tabIndex = 0;
    inLanguage(() => this.stage.canvas.setAttribute('aria-label', text('picture')));
    this.#listen();
    this.colourBy(quantities[0].key);
  }

  async start() {
    const { origin } = this.runs[0].scene;
    const alike = this.runs.filter(({ scene }) => scene.origin.every((x, k) => x === origin[k]));
    const ends = alike.flatMap((run) => [run.whenLoaded(0), run.whenLoaded(run.times.length - 1)]);
    this.home = homeView(this.runs[0], await Promise.all(ends));
    this.stage.look(this.home.points, this.home.azimuth, 36);
    this.setTime(0);
    requestAnimationFrame((now) => this.#tick(now, now));
  }

  colourBy(key) {
    this.legend.show(key);
    const k = quantities.findIndex((quantity) => quantity.key === key);
    for (const { particles } of this.stage.panes) {
      particles.material.uniforms.quantity.value = new Vector3(k === 0, k === 1, k === 2);
      particles.material.uniforms.top.value = this.legend.top;
    }
    this.stage.isDue = true;
  }

  setTime(time) {
    this.player.set(time);
    this.refresh();
  }

  play() {
    this.player.toggle();
    this.refresh();
  }

  step(direction) {
    this.player.step(direction);
    this.refresh();
  }

  setMode(mode) {
    this.stage.setMode(mode);
    this.controls.showMode(mode);
    this.refresh();
  }

  lookAgain() {
    this.stage.look(this.home.points, this.home.azimuth, 36);
  }

  /** Comes near to a dam or building, from the same side. */
  lookAt(anchor) {
    const [x, y, z] = anchor.at;
    const reach = Math.max(1.5 * anchor.size, 10 * this.runs[0].ground.dx);
    const around = [[-1, -1], [-1, 1], [1, -1], [1, 1]].map(([east, north]) =>
      [x + east * reach, y + north * reach, this.runs[0].ground.height(x, y)]);
    this.stage.look([...around, [x, y, z]], this.home.azimuth, 30);
  }

  lookFromAbove() {
    this.stage.look(this.home.points, 0, 89.9);
  }

  /** Shows the time as far as its frames are there; false while they are loaded. */
  refresh() {
    const { time, isSmooth } = this.player;
    const isThere = this.stage.panes.map(({ particles, run }) => {
      const isShown = particles.show(run.around(Math.min(time, run.end), isSmooth));
      run.lookAhead(time, 3);
      return isShown;
    }).every(Boolean);
    this.values.update(time, this.player.isBetween);
    this.labels.mark(this.values.mark);
    this.controls.showTime(!isThere);
    this.stage.isDue = true;
    return isThere;
  }

  savePicture() {
    const { scene } = this.runs[0];
    return savePicture({
      stage: this.stage, labels: this.labels, legend: this.legend,
      lines: [scene.title, scene.note, this.controls.timeText,
        this.player.isBetween && text('between'), scene.program],
      name: `sabo_${this.legend.key}_${this.player.time.toFixed(1)}s.png`,
    });
  }

  #tick(now, before) {
    if (this.player.isPlaying) {
      const { time } = this.player;
      this.player.advance((now - before) / 1000);
      if (!this.refresh()) this.player.time = time; // waits for the frames
    }
    if (this.stage.isDue) this.stage.draw();
    requestAnimationFrame((next) => this.#tick(next, now));
  }

  #listen() {
    const { canvas } = this.stage;
    let pressed = null;
    canvas.addEventListener('pointerdown', (event) => { pressed = [event.clientX, event.clientY]; });
    canvas.addEventListener('pointerup', (event) => {
      if (!pressed || event.button !== 0) return;
      const moved = Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]);
      if (moved < 5) this.#click(event);
    });
    window.addEventListener('keydown', (event) => this.#key(event));
  }

  #click(event) {
    const box = this.stage.canvas.getBoundingClientRect();
    this.values.set(pick(this.stage, event.clientX - box.left, event.clientY - box.top));
    this.labels.mark(this.values.mark);
  }

  #key(event) {
    const tag = event.target.tagName;
    if (event.ctrlKey || event.metaKey || event.altKey || tag === 'SELECT') return;
    if (tag === 'INPUT' && event.target.type === 'range' && event.key.startsWith('Arrow') &&
        event.target !== this.controls.slider) return;
    const modes = ['first', 'second'];
    const actions = {
      ' ': () => this.play(),
      ArrowRight: () => this.step(1),
      ArrowLeft: () => this.step(-1),
      Home: () => this.setTime(0),
      End: () => this.setTime(this.player.end),
      c: () => this.runs.length > 1 &&
        this.setMode(modes[(modes.indexOf(this.stage.mode) + 1) % 2]),
    };
    const action = actions[event.key];
    if (!action || (tag === 'BUTTON' && event.key === ' ')) return;
    event.preventDefault();
    action();
  }
}

/** Points to show (the way of the flow, sections), and from where: up the valley from aside. */
function homeView(run, frames) {
  const { ground } = run;
  const points = [];
  const include = (x, y) => ground.has(x, y) && points.push([x, y, ground.height(x, y)]);
  for (const { values, low, high, count } of frames) {
    const step = Math.max(1, Math.floor(count / 300));
    for (let i = 0; i < count; i += step)
      include(...[0, 1].map((k) => low[k] + ((high[k] - low[k]) * values[6 * i + k]) / 65535));
  }
  for (const { kind, points: line } of run.scene.lines)
    if (kind === 'section') line.forEach(([x, y]) => include(x, y));
  const [west, east] = [ground.x(0), ground.x(ground.columns - 1)];
  const [north, south] = [ground.y(0), ground.y(ground.rows - 1)];
  if (points.length < 2)
    for (const x of [west, east]) for (const y of [north, south]) points.push([x, y, ground.height(x, y)]);
  const path = run.scene.lines.find(({ kind }) => kind === 'path')?.points ?? [];
  if (path.length < 2) return { points, azimuth: 0 };
  const [[x0, y0], [x1, y1]] = [path[0], path.at(-1)];
  return { points, azimuth: (Math.atan2(x0 - x1, y0 - y1) * 180) / Math.PI + 42 };
}
