// Debian's Chromium with WebGL in software. A page that logs an error, throws, or breaks its policy fails its test.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';

const require = createRequire(new URL('../../../web/package.json', import.meta.url));
const { chromium } = require('playwright-core');

export const WIDE = { width: 1280, height: 800 };
export const NARROW = { width: 390, height: 844 };

export const startBrowser = () =>
  chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [
      '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox', '--disable-quic', '--no-first-run',
      '--disable-background-networking', '--disable-component-update', '--disable-sync',
    ],
  });

/** A page with a context of its own. `expected`: errors in the console that the test is about; `allowed`: other servers it may ask. */
export async function openPage(browser, address, { viewport = WIDE, theme = 'light', touch = false, expected = [], allowed = [], reducedMotion = 'reduce', bypassCSP = false, locale = 'en-GB' } = {}) {
  const context = await browser.newContext({ viewport, colorScheme: theme, hasTouch: touch, reducedMotion, acceptDownloads: true, bypassCSP, locale });
  const page = await context.newPage();
  page.setDefaultTimeout(Number(process.env.TRAMLINE_WAIT ?? 60_000));
  const faults = [];
  page.on('pageerror', (error) => faults.push(`error: ${error.message}`));
  page.on('console', (message) => {
    const text = message.text();
    if (message.type() === 'error' && !expected.some((pattern) => pattern.test(text))) faults.push(`console: ${text}`);
  });
  page.on('request', (request) => {
    if (/^https?:/.test(request.url()) && ![new URL(address).origin, ...allowed].some((origin) => request.url().startsWith(origin))) faults.push(`left the server: ${request.url()}`);
  });
  page.faults = faults;
  await page.goto(address);
  return page;
}

export async function closePage(page) {
  const { faults } = page;
  await page.context().close();
  assert.deepEqual(faults, [], 'nothing goes wrong in the background');
}
