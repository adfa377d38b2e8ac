import { element } from './dom.js';

const captionTop = 150; // px
const run = (pane) => pane.run.scene.run;

/** Names over the picture; those that would cover others are left out. */
export class Labels {
  constructor(holder, stage) {
    this.stage = stage;
    this.layer = element('div', { className: 'labels', attributes: { 'aria-hidden': true } });
    holder.append(this.layer);
    this.isShown = true;
    this.shown = new Set(['solid', 'section', 'zone', 'path', 'edit']);
    this.elements = new Map();
  }

  /** Marks a place of the scene; null takes the mark away. */
  mark(place) {
    this.marked = place;
    if (!this.ring) {
      this.ring = element('div', { className: 'ring' });
      this.layer.append(this.ring);
    }
    this.update();
  }

  /** Names of the runs at the top of their parts of the picture, and a line between them. */
  #placeCaptions() {
    const { stage } = this;
    this.captions ??= stage.panes.map(({ run }) => {
      const made = element('span', { className: 'caption', textContent: run.scene.run });
      this.layer.append(made);
      return made;
    });
    this.divider ??= this.layer.appendChild(element('div', { className: 'divider' }));
    this.divider.hidden = stage.views.length < 2;
    this.divider.style.transform = `translateX(${stage.views.at(-1).from - 1}px)`;
    stage.panes.forEach((pane, k) => {
      const view = stage.views.find((shown) => shown.pane === pane);
      this.captions[k].hidden = !view || stage.panes.length < 2;
      if (!view || stage.panes.length < 2) return;
      const x = (view.from + view.to) / 2;
      this.captions[k].style.transform = `translate(${x}px, ${captionTop}px) translateX(-50%)`;
      this.placed.push({ name: run(pane), kind: 'caption', left: x, right: x, top: captionTop });
    });
  }

  update() {
    const { stage } = this;
    const boxes = [];
    for (const { label } of this.elements.values()) label.hidden = true;
    this.placed = [];
    for (const view of stage.views) {
      const { pane, from, to } = view;
      for (const anchor of [...pane.solids.anchors, ...pane.lines.anchors]) {
        if (!this.isShown || !this.shown.has(anchor.kind)) continue;
        const at = stage.project(view, anchor.at);
        if (!at || at.x < from || at.x > to || at.y < 0 || at.y > stage.height) continue;
        const { label, width } = this.#label(view, anchor);
        const box = { left: at.x - width / 2, right: at.x + width / 2, top: at.y - 34, bottom: at.y - 12 };
        const isTaken = boxes.some((b) => box.left < b.right && box.right > b.left &&
          box.top < b.bottom && box.bottom > b.top);
        if (isTaken || box.left < from || box.right > to) continue;
        boxes.push(box);
        label.hidden = false;
        label.style.transform = `translate(${box.left}px, ${box.top}px)`;
        this.placed.push({ ...box, ...anchor });
      }
    }
    this.#placeCaptions();
    this.#placeRing();
  }

  #placeRing() {
    if (!this.ring) return;
    this.ring.hidden = true;
    if (!this.marked) return;
    const view = this.stage.views.find(({ pane }) => pane === this.marked.pane) ?? this.stage.views[0];
    const at = this.stage.project(view, this.marked.at);
    if (!at || at.x < view.from || at.x > view.to) return;
    this.ring.hidden = false;
    this.ring.style.transform = `translate(${at.x - 9}px, ${at.y - 9}px)`;
  }

  #label(view, anchor) {
    const key = `${this.stage.panes.indexOf(view.pane)} ${anchor.kind} ${anchor.name} ${anchor.at}`;
    if (!this.elements.has(key)) {
      const label = element('span', { className: `label ${anchor.kind}`, textContent: anchor.name });
      this.layer.append(label);
      this.elements.set(key, { label, width: label.offsetWidth });
    }
    return this.elements.get(key);
  }
}
