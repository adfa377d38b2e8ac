// The 3D view of a run, as its user meets it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';

import { withPage } from './browser.mjs';
import { makeRuns, roughTitle, withServer } from './runs.mjs';

let runs;
before(() => { runs = makeRuns(); });
after(() => runs.remove());

const ready = (page) => page.waitForSelector('html[data-state="ready"]', { timeout: 60000 });
/** What the clock says once the state that was asked for is there. */
const clock = async (page) => {
  await page.waitForFunction(() => / s of /.test(document.querySelector('.clock').textContent));
  return page.locator('.clock').textContent();
};
const toTime = (page, time) => page.locator('input.time').fill(String(time));

/** Where the middle of the flow is on the picture, px. */
const middleOfFlow = (page) => page.evaluate(() => {
  const { stage } = window.sabo_viewer;
  const [view] = stage.views;
  const { particles, run } = view.pane;
  const found = [];
  for (let i = 0; i < particles.count; ++i) {
    const [x, y, h] = particles.read(i, []);
    found.push({ at: stage.project(view, [x, y, run.ground.height(x, y) + h]), x, y });
  }
  const mean = (key) => found.reduce((sum, { at }) => sum + at[key], 0) / found.length;
  const middle = { x: mean('x'), y: mean('y') };
  found.sort((a, b) => Math.hypot(a.at.x - middle.x, a.at.y - middle.y) -
    Math.hypot(b.at.x - middle.x, b.at.y - middle.y));
  return found[0].at;
});

/** Number of colours in the picture: one alone would be an empty page. */
async function coloursOf(page) {
  const png = (await page.screenshot()).toString('base64');
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
    return new Set(pixels).size;
  }, png);
}

/** What every user does: slider, play, click, picture. */
async function tour(page) {
  await ready(page);
  assert.equal(await page.locator('h1').textContent(), roughTitle);
  assert.ok(await coloursOf(page) > 500);

  await toTime(page, 3);
  assert.match(await clock(page), /^3\.00 s of 5\.00 s$/);
  await page.keyboard.press('End');
  await page.keyboard.press('ArrowLeft');
  assert.match(await clock(page), /^4\.0\d s/); // the frame before the last
  const { x, y } = await middleOfFlow(page);
  await page.mouse.click(x, y);
  const values = await page.locator('.values table').innerText();
  const number = (name) => Number(values.match(new RegExp(`${name}\\s+([\\d.\\u2009]+)`))[1].replace('\u2009', ''));
  assert.ok(number('Depth') > 0.1 && number('Depth') < 30, values);
  assert.ok(number('Speed') > 0.1 && number('Speed') < 60, values);
  assert.match(values, /Pressure\s+[\d.\u2212-]+\s+kPa/);
  assert.match(values, /Place\s+350\u2009?\d{3}\.\d\s+3\u2009?1\d\d\u2009?\d{3}\.\d/);

  await page.keyboard.press('Home');
  await page.selectOption('footer select', '2');
  await page.keyboard.press('Space');
  await page.waitForFunction(() => window.sabo_viewer.player.time > 1, null, { timeout: 60000 });
  await page.keyboard.press('Space');
  assert.equal(await page.evaluate(() => window.sabo_viewer.player.isPlaying), false);

  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save picture' }).click();
  const png = readFileSync(await (await download).path());
  assert.equal(png.subarray(1, 4).toString(), 'PNG');
  assert.equal(png.readUInt32BE(16), page.viewportSize().width);
  assert.ok(png.length > 50000);
}

test('The view opens from disk', () => withPage(runs.page('with'), tour));

test('The view opens from sabo view', () =>
  withServer([runs.with], (address) => withPage(address, tour)));

test('The view fits a narrow screen', () => withPage(runs.page('with'), async (page) => {
  await ready(page);
  const { width } = await page.locator('.bar').boundingBox();
  assert.ok(width <= 390);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
}, { width: 390, height: 760 }));

async function compared(page) {
  await ready(page);
  await page.selectOption('.panel select >> nth=1', 'both');
  await toTime(page, 5);
  await page.waitForFunction(() => window.sabo_viewer.stage.panes.every(
    ({ particles }) => particles.shown.first?.time === 5));
  const { x, y } = await middleOfFlow(page);
  await page.mouse.click(x, y);
  const rows = await page.locator('.values tr').evaluateAll((all) => all.map((row) => row.cells.length));
  assert.ok(rows.length >= 5 && rows.every((cells) => cells === 4)); // name, two runs, unit
  await page.keyboard.press('c');
  assert.equal(await page.evaluate(() => window.sabo_viewer.stage.mode), 'first');
  await page.keyboard.press('c');
  assert.equal(await page.evaluate(() => window.sabo_viewer.stage.mode), 'second');
}

test('Two runs are compared, served', () => withServer([runs.with, '--with', runs.without],
  (address) => withPage(address, compared)));

test('Two runs are compared, from disk', () =>
  withPage(runs.page('with', '?with=../../without/view'), compared));

test('A second run from elsewhere is not loaded', () => withServer([runs.with], (address) =>
  withPage(`${address}?with=//example.org/`, async (page) => {
    await ready(page);
    assert.equal(await page.evaluate(() => window.sabo_viewer.runs.length), 1);
  })));
