// Opens pages in Debian's Chromium and watches what they do. A test of another page needs no more
// than withPage().
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

export const chromiumPath = process.env.CHROMIUM ??
  ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find((path) => existsSync(path));

/** Whether a page may ask for this: its own file system, this machine, or what it carries itself. */
function isAtHome(url) {
  const { protocol, hostname } = new URL(url);
  return ['file:', 'data:', 'blob:'].includes(protocol) || hostname === '127.0.0.1';
}

/** What the driver of the graphics says of its speed, of every page that is read back. */
const isRemarkOfDriver = (text) => text.includes('GL Driver Message') && text.includes('Performance');

/**
 * Calls test(page) with a page that has been opened, then fails if it wrote an error to the console,
 * threw, or asked for anything outside of this machine.
 */
export async function withPage(url, test, { width = 1280, height = 720 } = {}) {
  const browser = await chromium.launch({
    executablePath: chromiumPath,
    args: ['--no-sandbox', '--disable-gpu', '--enable-unsafe-swiftshader', '--disable-background-networking',
      '--disable-component-update', '--disable-sync', '--no-first-run'],
  });
  try {
    const context = await browser.newContext({
      viewport: { width, height }, locale: 'en-GB', acceptDownloads: true,
    });
    const page = await context.newPage();
    const faults = [];
    page.on('console', (message) => {
      if (!['error', 'warning'].includes(message.type()) || isRemarkOfDriver(message.text())) return;
      faults.push(`console: ${message.text()}`);
    });
    page.on('pageerror', (error) => faults.push(`thrown: ${error.message}`));
    page.on('request', (request) => {
      if (!isAtHome(request.url())) faults.push(`asked for ${request.url()}`);
    });
    await page.goto(url);
    await test(page);
    assert.deepEqual(faults, []);
  } finally {
    await browser.close();
  }
}
