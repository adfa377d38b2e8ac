// The report of a run, as its reader meets it: on the screen, under the pointer and on paper.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { withPage } from './browser.mjs';
import { makeRuns, roughTitle } from './runs.mjs';

let runs;
before(() => {
  runs = makeRuns();
  const report = (...words) => execFileSync(process.env.SABO_PROGRAM ?? 'sabo', ['report', runs.with, ...words]);
  report('--compare', runs.without);
  report('--language', 'ja');
});
after(() => runs.remove());

const url = (name) => pathToFileURL(join(runs.with, name)).href;
const ready = (page) => page.waitForSelector('html[data-ready]', { timeout: 60000 });

/** What the legend of a chart says of a place in the middle of it. */
async function valuesOf(page, chart) {
  await chart.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await chart.locator('.u-over').boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  const values = chart.locator('.u-legend .u-value');
  await page.waitForTimeout(200);
  return values.allTextContents();
}

async function read(page, { sections }) {
  await ready(page);
  assert.equal(await page.locator('h1').textContent(), roughTitle);
  const titles = await page.locator('h2').allTextContents();
  for (const title of sections) assert.ok(titles.some((text) => text.includes(title)), `${title}: ${titles}`);
  const charts = await page.locator('figure.chart').count();
  assert.ok(charts >= 8);
  assert.equal(await page.locator('figure.chart.is-live canvas').count(), charts);
  const discharge = page.locator('figure.chart', { hasText: 'discharge.csv' }).first();
  const [time, ...flow] = await valuesOf(page, discharge);
  assert.match(time, /^2\.\d/); // of five seconds
  assert.ok(flow.length >= 1 && flow.every((value) => /^[\d.\u2212]+$/.test(value)), String(flow));
  const { width } = page.viewportSize();
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width);

  const pdf = await page.pdf({ preferCSSPageSize: true });
  assert.equal(pdf.subarray(0, 5).toString(), '%PDF-');
  const pages = pdf.toString('latin1').match(/\/Type\s*\/Page\b/g).length;
  assert.ok(pages >= 5 && pages <= 30, `${pages} pages`);
  assert.match(pdf.toString('latin1'), /\/MediaBox\s*\[0 0 (594|595)[\d.]* (841|842)/); // A4
}

test('The report reads in English', () => withPage(url('report.html'), (page) =>
  read(page, { sections: ['Location', 'Maps', 'Hydrographs', 'Comparison', 'Limits of validity'] })));

test('The report reads in Japanese', () => withPage(url('report_ja.html'), (page) =>
  read(page, { sections: ['位置と地形', '平面図', 'ハイドログラフ', '適用範囲と限界'] })));

/** Columns of a series by their names. */
function seriesOf(file) {
  const [names, ...rows] = readFileSync(join(runs.with, 'series', file), 'utf8').trim().split('\n')
    .map((line) => line.split(','));
  return Object.fromEntries(names.map((name, k) => [name, rows.map((row) => Number(row[k]))]));
}

test('Numbers of the report are those of the files', () => withPage(url('report.html'), async (page) => {
  await ready(page);
  const cell = (name) => page.locator('tr', { hasText: name }).locator('td').nth(1).textContent();
  const front = seriesOf('front.csv');
  assert.equal(await cell('Greatest speed'), Math.max(...front['velocity [m/s]']).toFixed(1));
  assert.equal(Number(await cell('Run-out')), Number(front['displacement [m]'].at(-1).toPrecision(3)));
  const { 'lowest density ratio': low, 'highest density ratio': high } = seriesOf('solver.csv');
  assert.equal(await cell('Density over reference density'),
    `${Math.min(...low.slice(1)).toFixed(4)} – ${Math.max(...high.slice(1)).toFixed(4)}`);
  const data = await page.locator('figure.chart', { hasText: 'front.csv' }).first().locator('script').textContent();
  const drawn = JSON.parse(data).series[0].y;
  assert.deepEqual(drawn, front['position [m]'].map((value) => Number(value.toPrecision(6))));
}));

test('On paper the charts are drawn', () => withPage(url('report.html'), async (page) => {
  await ready(page);
  const chart = page.locator('figure.chart').first();
  assert.equal(await chart.locator(':scope > svg').isVisible(), false);
  await page.emulateMedia({ media: 'print' });
  assert.equal(await chart.locator(':scope > svg').isVisible(), true);
  assert.equal(await chart.locator('.live').isVisible(), false);
}));

test('The report fits a narrow screen', () => withPage(url('report.html'), async (page) => {
  await ready(page);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
}, { width: 390, height: 760 }));
