// axe-core finds nothing in any view, by day and by night, on a desk, a tablet and a phone.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { NARROW } from './support/browser.mjs';
import { flow } from './support/flow.mjs';
import { chooseFile, goTo, makePlan, openField, still } from './support/page.mjs';
import { example } from './support/server.mjs';
import { smallField } from './support/stored.mjs';

const axe = readFileSync(createRequire(new URL('../../web/package.json', import.meta.url)).resolve('axe-core/axe.min.js'), 'utf8');

async function assertClean(page, where) {
  await page.evaluate(() => document.querySelectorAll('main details').forEach((details) => { details.open = true; }));
  await page.evaluate((source) => { if (!window.axe) (0, eval)(source); }, axe).catch(() => page.addScriptTag({ content: axe }));
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
  assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html }) => html.slice(0, 160)).join(' | ')}`), [], where);
}

for (const [name, options] of [
  ['a desk by day', {}],
  ['a tablet by night', { theme: 'dark', viewport: { width: 1024, height: 768 }, touch: true }],
  ['a phone by day', { viewport: NARROW, touch: true }],
]) {
  flow(`axe-core on ${name}`, { ...options, bypassCSP: true }, async ({ page, server }) => {
    await assertClean(page, 'an empty store');
    await page.getByRole('button', { name: 'Language and units' }).click();
    await assertClean(page, 'language and units');
    await page.getByRole('button', { name: 'Done' }).click();
    await chooseFile(page, 'Choose a file with a field', example('two-farms.gpkg'));
    await page.getByRole('heading', { name: /Which field/ }).waitFor();
    await assertClean(page, 'a file of several fields');
    await page.getByRole('button', { name: 'Back' }).click();
    await openField(page, smallField(server.folder));
    await assertClean(page, 'a field');
    await page.getByRole('button', { name: 'Change the boundary' }).click();
    await assertClean(page, 'drawing');
    await page.locator('.drawing-bar').getByRole('button', { name: 'Cancel' }).click();
    await goTo(page, 'Plan');
    await assertClean(page, 'the form of a plan');
    await makePlan(page);
    await still(page);
    await page.getByRole('button', { name: 'Drive the route' }).evaluate((button) => button.click());
    await page.getByLabel('Which display?').selectOption('qgc');
    await page.getByRole('button', { name: 'Open it on the phone' }).click();
    await page.getByText(/Only this computer can open/).waitFor();
    await assertClean(page, 'a plan');
    await page.getByRole('button', { name: 'Forbid an area' }).click();
    await assertClean(page, 'forbidding an area');
    await page.locator('.drawing-bar').getByRole('button', { name: 'Cancel' }).click();
    await goTo(page, 'Compare');
    await page.getByRole('button', { name: 'Find the plans' }).click();
    await page.locator('.dot').first().waitFor({ timeout: 60_000 });
    await page.locator('.dot').last().click({ force: true });
    await page.getByRole('region', { name: 'Differences of the two plans' }).waitFor();
    await assertClean(page, 'a comparison');
    await goTo(page, 'Review');
    await chooseFile(page, 'Choose the log of a machine', example('riverside-drive.csv'));
    await page.getByRole('button', { name: 'Show what was worked' }).waitFor();
    await assertClean(page, 'a log');
    await page.getByRole('button', { name: 'Show what was worked' }).click();
    await page.getByRole('group', { name: 'Replay' }).waitFor({ timeout: 60_000 });
    await assertClean(page, 'a drive');
  });
}
