// The pictures of docs/page.md, of example data only. Usage: pictures.mjs FOLDER
import { join } from 'node:path';
import { closePage, NARROW, openPage, startBrowser, WIDE } from './support/browser.mjs';
import { chooseFile, clickMap, goTo, makePlan, mapReady, newPlan, openField, still } from './support/page.mjs';
import { example, startServer } from './support/server.mjs';

const folder = process.argv[2];
const only = process.argv[3] ?? '';
const browser = await startBrowser();
const server = await startServer();

async function shoot(page, name) {
  await still(page);
  await page.mouse.move(700, 790);
  if (name.includes(only)) await page.screenshot({ path: join(folder, `page-${name}.png`) });
}
const top = (page) => page.locator('main.panel').evaluate((panel) => panel.scrollTo(0, 0));

/** Draws corners, which are parts of the field's box, from its south-west. */
async function drawn(page, button, done, corners) {
  const before = new URL(page.url()).hash;
  const [field] = await (await fetch(`${server.address}/api/v1/fields`)).json();
  const [west, south, east, north] = field.bbox;
  await page.getByRole('button', { name: button }).click();
  for (const [x, y] of corners) await clickMap(page, [west + x * (east - west), south + y * (north - south)]);
  await page.getByRole('button', { name: done }).click();
  await newPlan(page, before);
  await page.waitForSelector('.map[aria-busy=false]');
}

async function plan(page) {
  await goTo(page, 'Plan');
  await makePlan(page);
  await page.waitForSelector('.map[aria-busy=false]');
  await page.locator('.maplibregl-canvas').focus(); // the figures have the focus after planning
  await page.evaluate(() => document.activeElement.blur());
  await top(page);
}

try {
  const wide = await openPage(browser, server.address, { viewport: WIDE });
  await mapReady(wide);
  await openField(wide, example('riverside.geojson'));
  await shoot(wide, 'fields');
  await plan(wide);
  await shoot(wide, 'plan');
  await drawn(wide, 'Forbid an area', 'Forbid this area', [[0.3, 0.3], [0.42, 0.3], [0.42, 0.42], [0.3, 0.42]]);
  await wide.getByRole('region', { name: 'By hand' }).evaluate((section) => section.scrollIntoView());
  await shoot(wide, 'hand');
  await wide.getByLabel('Which display?').selectOption('claas');
  await wide.getByRole('region', { name: 'Onto the machine' }).evaluate((section) => section.scrollIntoView());
  await shoot(wide, 'along');
  await goTo(wide, 'Compare');
  await wide.getByRole('button', { name: 'Find the plans' }).click();
  await wide.locator('.dot').first().waitFor({ timeout: 300_000 });
  const before = new URL(wide.url()).hash;
  await wide.locator('.dot').last().click({ force: true });
  await wide.waitForFunction((was) => location.hash !== was, before);
  await wide.getByText(/^Making plan/).waitFor({ state: 'detached' });
  await wide.waitForSelector('.map[aria-busy=false]');
  await wide.getByRole('region', { name: 'Differences of the two plans' }).waitFor();
  await top(wide);
  await shoot(wide, 'compare');
  await goTo(wide, 'Review');
  await chooseFile(wide, 'Choose the log of a machine', example('riverside-drive.csv'));
  await wide.getByRole('button', { name: 'Show what was worked' }).click();
  await wide.getByRole('group', { name: 'Replay' }).waitFor({ timeout: 60_000 });
  await wide.locator('section.open').evaluate((section) => section.scrollIntoView());
  await shoot(wide, 'review');
  await wide.getByLabel('Speed').selectOption('100');
  await wide.getByRole('button', { name: 'Play the drive' }).click();
  await wide.waitForFunction(() => /^0:(2[5-9]|[3-5])/.test(document.querySelector('.replay output').textContent), null, { timeout: 300_000 });
  await wide.getByRole('button', { name: 'Pause the replay' }).click();
  await shoot(wide, 'replay');
  const { hash } = new URL(wide.url());
  await closePage(wide);

  const night = await openPage(browser, `${server.address}/${hash.replace('view=review', 'view=plan')}`, { viewport: NARROW, theme: 'dark', touch: true });
  await mapReady(night);
  await night.getByLabel('The plan in numbers').first().waitFor();
  await shoot(night, 'night');
  await closePage(night);
} finally {
  await browser.close();
  await server.stop();
}
