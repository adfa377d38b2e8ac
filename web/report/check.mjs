// Opens a report from disk in Chromium and looks at what a reader does. `checkReport` is for other
// checks; alone: node check.mjs REPORT.html [FOLDER for a screenshot and a PDF]
import { readFileSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

function expect(condition, message) {
  if (!condition) throw new Error(message);
}

/// Throws if the report asks for anything outside of it, prints errors, lacks charts or does not
/// give values under the pointer. Returns what it saw.
export async function checkReport(browser, file, folder) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  const errors = [];
  const requests = [];
  const url = pathToFileURL(resolve(file)).href;
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('request', (request) => {
    const isOwn = request.url() === url || request.url().startsWith('data:');
    if (!isOwn) requests.push(request.url());
  });
  await page.goto(url);
  await page.waitForSelector('html[data-ready]');

  const charts = await page.locator('figure.chart').count();
  const live = await page.locator('figure.chart.is-live canvas').count();
  expect(charts > 0 && live > 0, `${live} of ${charts} charts are live`);

  // A value of the first chart under the pointer, in the middle of the plot.
  const first = page.locator('figure.chart.is-live').first();
  await first.scrollIntoViewIfNeeded();
  const over = await first.locator('.u-over').boundingBox();
  await page.mouse.move(over.x + over.width / 2, over.y + over.height / 2);
  await page.waitForFunction(() =>
    /\d/.test(document.querySelector('figure.chart.is-live .u-legend .u-series:nth-child(2) .u-value')?.textContent ?? ''));
  const value = await first.locator('.u-legend .u-value').allTextContents();

  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(wide <= 0, `the page is ${wide} px wider than the window`);
  expect(errors.length === 0, `errors on the console:\n${errors.join('\n')}`);
  expect(requests.length === 0, `the report asks for:\n${requests.join('\n')}`);

  const sections = await page.locator('h2').allTextContents();
  let pdf = 0;
  if (folder) {
    await page.screenshot({ path: join(folder, 'report.png'), fullPage: true });
    const path = join(folder, 'report.pdf');
    await page.pdf({ path, preferCSSPageSize: true, printBackground: true });
    pdf = statSync(path).size;
    expect(readFileSync(path).subarray(0, 5).toString() === '%PDF-', 'no PDF was printed');
  }
  await page.close();
  return { charts, live, value, sections, pdf };
}

if (process.argv[1] && import.meta.url === pathToFileURL(resolve(process.argv[1])).href) {
  const [file, folder] = process.argv.slice(2);
  if (!file) throw new Error('usage: node check.mjs REPORT.html [FOLDER]');
  const { chromium } = await import('playwright-core');
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu'],
  });
  try {
    console.log(await checkReport(browser, file, folder));
  } finally {
    await browser.close();
  }
}
