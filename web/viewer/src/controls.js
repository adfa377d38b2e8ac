import { button, checkbox, choice, element, inLanguage, named, slider, translateAll, words } from './dom.js';
import { quantities } from './quantities.js';
import { languages, setLanguage, text } from './text.js';

const modes = { first: 'first', second: 'second', both: 'both', swipe: 'swipe' };

/** Everything around the picture. */
export class Controls {
  constructor(viewer) {
    this.viewer = viewer;
    document.body.append(this.#title(), this.#panel(), viewer.values.element, this.#bar());
  }

  #title() {
    const { scene } = this.viewer.runs[0];
    const about = element('p', { className: 'about' });
    inLanguage(() => {
      const part = scene.one_of > 1 ? text('part', { n: scene.one_of }) : '';
      about.textContent = text('about', {
        shown: Math.max(...scene.frames.map(([, , count]) => count)), part,
        frames: scene.frames.length, program: scene.program,
      });
    });
    const titles = this.viewer.runs.map((run) => run.scene.title);
    const isSame = titles.every((title) => title === titles[0]);
    document.title = scene.title;
    return element('header', { className: 'card title' },
      element('h1', { textContent: isSame ? titles[0] : titles.join(' | ') }),
      ...(scene.note ? [element('p', { className: 'note', textContent: scene.note })] : []), about);
  }

  #panel() {
    const { viewer } = this;
    const { stage, labels, player, runs } = viewer;
    const show = (change) => (isShown) => {
      change(isShown);
      stage.cameraMoved();
    };
    const colours = Object.fromEntries(quantities.map(({ key }) => [key, key]));
    const redraw = () => { stage.isDue = true; };
    const items = [
      choice('colour', colours, quantities[0].key, (key) => viewer.colourBy(key)),
      ...(runs.length > 1 ? this.#comparison() : []),
      slider('exaggeration', { min: 1, max: 4, step: 0.25, value: 1, show: (v) => `${v}×` },
        (v) => { stage.setExaggeration(v); viewer.refresh(); }),
      slider('pointSize', { min: 0.25, max: 2, step: 0.05, value: 1, show: (v) => `${v.toFixed(2)}×` },
        (v) => {
          for (const { particles, run } of stage.panes)
            particles.material.uniforms.size.value = v * run.scene.spacing;
          redraw();
        }),
      checkbox('solids', true, show((isShown) => stage.panes.forEach((pane) => {
        pane.solids.group.visible = isShown;
        labels.shown[isShown ? 'add' : 'delete']('solid');
      }))),
      checkbox('lines', true, show((isShown) => stage.panes.forEach((pane) => {
        pane.lines.group.visible = isShown;
        for (const kind of ['section', 'zone', 'path', 'edit'])
          labels.shown[isShown ? 'add' : 'delete'](kind);
      }))),
      checkbox('labels', true, (isShown) => { labels.isShown = isShown; redraw(); }),
      checkbox('contours', true, show((isShown) => stage.panes.forEach((pane) => {
        const { contour } = pane.terrain.surface.material.uniforms;
        pane.contour ??= contour.value;
        contour.value = isShown ? pane.contour : 0;
      }))),
      checkbox('smooth', true, (isSmooth) => { player.isSmooth = isSmooth; viewer.refresh(); }),
      ...this.#nearViews(),
      element('div', { className: 'buttons' },
        button('reset', () => viewer.lookAgain()), button('above', () => viewer.lookFromAbove()),
        button('screenshot', () => viewer.savePicture())),
      choice('language', languages, document.documentElement.lang, (code) => {
        setLanguage(code);
        translateAll();
        viewer.refresh();
      }, true),
    ];
    const isWide = window.matchMedia('(min-width: 760px)').matches;
    return element('details', { className: 'card panel', open: isWide },
      words('summary', 'settings'), ...items);
  }

  /** A choice of dams and buildings to come near to. */
  #nearViews() {
    const anchors = this.viewer.stage.panes.flatMap((pane) => pane.solids.anchors);
    if (anchors.length === 0) return [];
    const made = choice('lookAt', { '': 'all' }, '', (k) =>
      (k === '' ? this.viewer.lookAgain() : this.viewer.lookAt(anchors[k])));
    anchors.forEach(({ name }, k) => made.select.append(
      element('option', { value: k, textContent: name })));
    this.lookAt = made.select;
    return [made];
  }

  #comparison() {
    const { viewer } = this;
    const mode = choice('compare', modes, 'first', (value) => viewer.setMode(value));
    named(mode.select, 'swap');
    this.mode = mode.select;
    this.swipe = slider('swipeAt', { min: 0, max: 1, step: 0.01, value: 0.5, show: () => '' }, (v) => {
      viewer.stage.swipe = v;
      viewer.stage.isDue = true;
    });
    this.swipe.hidden = true;
    return [mode, this.swipe];
  }

  showMode(mode) {
    this.mode.value = mode;
    this.swipe.hidden = mode !== 'swipe';
  }

  #bar() {
    const { viewer } = this;
    const { player } = viewer;
    this.playButton = named(element('button', {
      type: 'button', className: 'icon play', onclick: () => viewer.play(),
    }), 'playOrPause');
    this.slider = element('input', {
      type: 'range', min: 0, max: player.end, step: 'any', value: 0, className: 'time',
      oninput: () => viewer.setTime(Number(this.slider.value)),
    });
    named(this.slider, 'time');
    this.shownTime = element('output', { className: 'clock' });
    const rates = element('select', { onchange: () => { player.rate = Number(rates.value); } });
    for (const rate of player.rates) {
      const option = element('option', { value: rate });
      inLanguage(() => { option.textContent = text('times', { rate }); });
      rates.append(option);
    }
    rates.value = player.rate;
    named(rates, 'playSpeed');
    return element('footer', {}, viewer.legend.element,
      element('div', { className: 'card bar' }, this.playButton,
        button('earlier', () => viewer.step(-1), '‹'), button('later', () => viewer.step(1), '›'),
        this.slider, this.shownTime, rates));
  }

  get timeText() {
    const { time, end } = this.viewer.player;
    const digits = end < 10 ? 2 : 1;
    return text('timeValue', { time: time.toFixed(digits), end: end.toFixed(digits) });
  }

  showTime(isLoading) {
    const { player } = this.viewer;
    this.slider.value = player.time;
    const shown = isLoading ? text('loading') : this.timeText;
    this.shownTime.textContent = shown;
    this.slider.setAttribute('aria-valuetext', shown);
    this.playButton.textContent = player.isPlaying ? '❚❚' : '▶';
    this.playButton.setAttribute('aria-pressed', player.isPlaying);
  }
}
