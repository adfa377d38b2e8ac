// The colours of the maps (src/io/output/colour_scale.cpp): viridis from light to dark.
export const viridis = [
  [253, 231, 37], [173, 220, 48], [94, 201, 98], [40, 174, 128], [33, 145, 140],
  [44, 114, 142], [59, 82, 139], [71, 44, 122], [68, 1, 84],
];

export const css = ([r, g, b]) => `rgb(${r}, ${g}, ${b})`;

export const gradient = (direction) => `linear-gradient(${direction}, ${viridis.map(css).join(', ')})`;

/** The largest of 1, 2, 5 x 10^n that is not above the value. */
function roundDown(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const lead = (value / power) * (1 + 1e-12);
  return power * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

/** Round numbers from 0 to at or above the top, about `count` steps. */
export function ticksUpTo(top, count = 5) {
  const step = roundDown((1.5 * (top > 0 ? top : 1)) / count);
  const decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  const values = [];
  for (let k = 0; k <= Math.ceil((top > 0 ? top : 1) / step - 1e-9); ++k) values.push(k * step);
  return { values, labels: values.map((value) => value.toFixed(decimals)), top: values.at(-1) };
}
