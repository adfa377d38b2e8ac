/** Names over the picture; those that would cover others are left out. */
export class Labels {
  constructor(holder, stage) {
    this.stage = stage;
    this.layer = document.createElement('div');
    this.layer.className = 'labels';
    this.layer.setAttribute('aria-hidden', 'true');
    holder.append(this.layer);
    this.isShown = true;
    this.shown = new Set(['solid', 'section', 'zone', 'path', 'edit']);
    this.elements = new Map();
  }

  /** Marks a place of the scene; null takes the mark away. */
  mark(place) {
    this.marked = place;
    if (!this.ring) {
      this.ring = document.createElement('div');
      this.ring.className = 'ring';
      this.layer.append(this.ring);
    }
    this.update();
  }

  update() {
    const { stage } = this;
    const boxes = [];
    for (const { element } of this.elements.values()) element.hidden = true;
    this.placed = [];
    for (const view of stage.views) {
      const { pane, from, to } = view;
      for (const anchor of [...pane.solids.anchors, ...pane.lines.anchors]) {
        if (!this.isShown || !this.shown.has(anchor.kind)) continue;
        const at = stage.project(view, anchor.at);
        if (!at || at.x < from || at.x > to || at.y < 0 || at.y > stage.height) continue;
        const { element, width } = this.#element(view, anchor);
        const box = { left: at.x - width / 2, right: at.x + width / 2, top: at.y - 34, bottom: at.y - 12 };
        const isTaken = boxes.some((b) => box.left < b.right && box.right > b.left &&
          box.top < b.bottom && box.bottom > b.top);
        if (isTaken || box.left < from || box.right > to) continue;
        boxes.push(box);
        element.hidden = false;
        element.style.transform = `translate(${box.left}px, ${box.top}px)`;
        this.placed.push({ ...box, ...anchor });
      }
    }
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

  #element(view, anchor) {
    const key = `${this.stage.panes.indexOf(view.pane)} ${anchor.kind} ${anchor.name} ${anchor.at}`;
    if (!this.elements.has(key)) {
      const element = document.createElement('span');
      element.className = `label ${anchor.kind}`;
      element.textContent = anchor.name;
      this.layer.append(element);
      this.elements.set(key, { element, width: element.offsetWidth });
    }
    return this.elements.get(key);
  }
}
