import { text } from './text.js';

const translated = []; // what to do again when the language changes

/** Calls `apply` now and after each change of the language. */
export function inLanguage(apply) {
  translated.push(apply);
  apply();
}

export function translateAll() {
  translated.forEach((apply) => apply());
}

/** An element with properties, attributes (in `attributes`) and children. */
export function element(tag, properties = {}, ...children) {
  const { attributes = {}, ...rest } = properties;
  const made = Object.assign(document.createElement(tag), rest);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/** An element whose text is `key` of the table of words. */
export function words(tag, key, properties = {}) {
  const made = element(tag, properties);
  inLanguage(() => { made.textContent = text(key); });
  return made;
}

/** Sets title and label of an element. */
export function named(made, key) {
  inLanguage(() => {
    made.title = text(key);
    made.setAttribute('aria-label', text(key));
  });
  return made;
}

export function button(key, onclick, icon = null) {
  const made = element('button', { type: 'button', onclick });
  if (!icon) {
    inLanguage(() => { made.textContent = text(key); });
    return made;
  }
  made.textContent = icon;
  made.className = 'icon';
  return named(made, key);
}

export function checkbox(key, checked, onchange) {
  const input = element('input', { type: 'checkbox', checked });
  input.onchange = () => onchange(input.checked);
  return element('label', { className: 'check' }, input, words('span', key));
}

export function slider(key, { min, max, step, value, show }, oninput) {
  const input = element('input', { type: 'range', min, max, step, value });
  const shown = element('output', { textContent: show(value) });
  input.oninput = () => {
    shown.textContent = show(Number(input.value));
    oninput(Number(input.value));
  };
  return element('label', { className: 'slide' }, words('span', key), input, shown);
}

/** A choice of {value: key of its text}, or of {value: text} if `isText`. */
export function choice(key, options, value, onchange, isText = false) {
  const select = element('select');
  for (const [option, name] of Object.entries(options)) {
    const made = element('option', { value: option });
    if (isText) made.textContent = name;
    else inLanguage(() => { made.textContent = text(name); });
    select.append(made);
  }
  select.value = value;
  select.onchange = () => onchange(select.value);
  const label = element('label', { className: 'choice' }, words('span', key), select);
  return Object.assign(label, { select });
}
