import { gradient, ticksUpTo } from './colours.js';
import { element, inLanguage, named } from './dom.js';
import { quantities } from './quantities.js';
import { text } from './text.js';

/** The scale of the colours: fixed over all times, and for both runs the same. */
export class Legend {
  constructor(runs) {
    this.ticks = Object.fromEntries(quantities.map(({ key, scale }) => [
      key, ticksUpTo(scale * Math.max(...runs.map((run) => run.scene.tops[key] ?? 0))),
    ]));
    this.title = element('div', { className: 'legend-title' });
    this.bar = element('div', { className: 'legend-bar' });
    this.bar.style.background = gradient('to right');
    this.marks = element('div', { className: 'legend-marks' });
    this.element = named(
      element('section', { className: 'card legend', attributes: { role: 'img' } },
        this.title, this.bar, this.marks), 'clipped');
    this.show(quantities[0].key);
    inLanguage(() => this.show(this.key));
  }

  get heading() {
    const { unit } = quantities.find(({ key }) => key === this.key);
    return `${text(`${this.key}Long`)} [${unit}]`;
  }

  /** Value of the darkest colour in the unit of a frame. */
  get top() {
    const { scale } = quantities.find(({ key }) => key === this.key);
    return this.ticks[this.key].top / scale;
  }

  get marksNow() {
    const { values, labels, top } = this.ticks[this.key];
    return values.map((value, k) => ({ at: value / top, label: labels[k] }));
  }

  show(key) {
    this.key = key;
    this.title.textContent = this.heading;
    this.marks.replaceChildren(...this.marksNow.map(({ at, label }) => {
      const mark = element('span', { textContent: label });
      mark.style.left = `${100 * at}%`;
      return mark;
    }));
    this.element.setAttribute('aria-label',
      `${this.heading}: 0 – ${this.ticks[key].labels.at(-1)}. ${text('clipped')}`);
  }
}
