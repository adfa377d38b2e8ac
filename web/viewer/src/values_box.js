import { button, element, inLanguage, words } from './dom.js';
import { valuesAt } from './probe.js';
import { quantities } from './quantities.js';
import { text } from './text.js';

const spaced = (value, digits) =>
  value.toFixed(digits).replace(/\B(?=(\d{3})+(?!\d))/g, (match, _, at, whole) =>
    (whole.indexOf('.') >= 0 && at > whole.indexOf('.') ? '' : '\u2009'));

/** The values at the place that was clicked, of each run, at the time that is shown. */
export class ValuesBox {
  constructor(stage, onclose) {
    this.stage = stage;
    this.place = null;
    this.rows = element('tbody');
    this.heading = element('h2');
    this.element = element('section', {
      className: 'card values', hidden: true, attributes: { 'aria-live': 'polite' },
    }, element('header', {}, this.heading, button('close', () => { this.set(null); onclose(); }, '×')),
    element('table', {}, this.rows));
    this.remark = element('p', { className: 'about' });
    this.element.append(this.remark);
    this.time = 0;
    this.isBetween = false;
    inLanguage(() => this.update(this.time, this.isBetween));
  }

  /** A place of pick(), or null. */
  set(place) {
    this.place = place;
    this.element.hidden = !place;
    this.update(this.time, this.isBetween);
  }

  /** Where the place is now, for a mark: on the flow if there is some. */
  get mark() {
    if (!this.place || !this.found) return null;
    const { ground, flow } = this.found;
    return { pane: this.pane, at: [this.x, this.y, (ground ?? 0) + (flow ? flow.height : 0)] };
  }

  update(time, isBetween) {
    this.time = time;
    this.isBetween = isBetween;
    if (!this.place) return;
    const { pane: clicked } = this.place.view;
    const [ox, oy] = clicked.run.scene.origin;
    const east = ox + this.place.x, north = oy + this.place.y;
    const panes = this.stage.panes;
    const all = panes.map((pane) => {
      const [x, y] = [east - pane.run.scene.origin[0], north - pane.run.scene.origin[1]];
      return { pane, x, y, found: valuesAt(pane, x, y) };
    });
    const here = all.find(({ pane }) => pane === clicked);
    [this.pane, this.x, this.y, this.found] = [clicked, here.x, here.y, here.found];

    this.heading.textContent = `${text('values')} ${text('atTime', { time: time.toFixed(1) })}`;
    this.remark.textContent = text('between');
    this.remark.hidden = !isBetween;
    const row = (key, unit, cells) => element('tr', {},
      element('th', { textContent: text(key), scope: 'row' }),
      ...cells.map((cell) => element('td', { textContent: cell })),
      element('td', { className: 'unit', textContent: unit }));
    const each = (value) => all.map(({ found }) => value(found) ?? '–');
    const rows = [];
    if (panes.length > 1)
      rows.push(row('compare', '', panes.map(({ run }) => run.scene.run)));
    rows.push(row('place', 'm', panes.map((_, k) =>
      (k === 0 ? `${spaced(east, 1)}  ${spaced(north, 1)}` : ''))));
    rows.push(row('elevation', 'm', each(({ ground }) => ground !== null && spaced(ground, 1))));
    const hasFlow = all.some(({ found }) => found.flow);
    if (!hasFlow) rows.push(row('depth', '', each(() => text('noFlow'))));
    for (const { key, unit, scale, digits } of hasFlow ? quantities : [])
      rows.push(row(key, unit, each(({ flow }) => flow && spaced(scale * flow[key], digits))));
    if (hasFlow)
      rows.push(row('heightOver', 'm', each(({ flow }) => flow && spaced(flow.height, 1))));
    this.rows.replaceChildren(...rows);
  }
}
