import './raw_colours.js';

import { element } from './dom.js';
import { Run } from './run.js';
import { setLanguage, text } from './text.js';
import { Viewer } from './viewer.js';

/**
 * Where the second run is, from "?with=...": below this page when it is served, and any folder by
 * a relative path when it is opened from disk.
 */
function otherBase() {
  const wish = new URLSearchParams(location.search).get('with');
  if (!wish) return null;
  const base = wish.endsWith('/') ? wish : `${wish}/`;
  const isServed = location.protocol !== 'file:';
  if (isServed ? base !== 'with/' : !/^[^:/\\?#][^:\\?#]*$/.test(base)) return null;
  return base;
}

function tell(message) {
  document.querySelector('.message')?.remove();
  document.body.append(element('p', {
    className: 'message', textContent: message, attributes: { role: 'alert' },
  }));
}

async function load(base, failure) {
  try {
    return await Run.load(base);
  } catch (error) {
    tell(error.message === 'format' ? text('otherFormat') : failure);
    return null;
  }
}

async function main() {
  setLanguage(navigator.language.startsWith('ja') ? 'ja' : 'en');
  if (!document.createElement('canvas').getContext('webgl2')) return tell(text('noGraphics'));
  const run = await load('', text('noRun'));
  if (!run) return;
  const base = otherBase();
  const other = base && await load(base, text('noOther', { base }));
  for (const each of [run, other]) {
    if (each) each.onMissing = (file) => tell(text('noFrame', { file }));
  }
  const holder = element('main');
  document.body.append(holder);
  const viewer = new Viewer(other ? [run, other] : [run], holder);
  window.sabo_viewer = viewer; // for the console and tests
  await viewer.start();
  document.documentElement.dataset.state = 'ready';
}

main();
