// From a plan to the file of a display, to the line card, and to the phone beside it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { flow, long } from '../support/flow.mjs';
import { goTo, makePlan, openField, panel } from '../support/page.mjs';
import { tramline } from '../support/server.mjs';
import { openId, smallField } from '../support/stored.mjs';

async function saved(page, press, folder) {
  const [file] = await Promise.all([page.waitForEvent('download'), press()]);
  const path = join(folder, file.suggestedFilename());
  await file.saveAs(path);
  return path;
}
const entries = (zip) => execFileSync('unzip', ['-Z1', zip], { encoding: 'utf8' }).trim().split('\n').sort();
const entry = (zip, name) => execFileSync('unzip', ['-p', zip, name], { encoding: 'utf8' });

flow('an empty store to the file of a terminal', { skip: long }, async ({ page, server }) => {
  let clicks = 0;
  const click = async (locator) => {
    clicks++;
    await locator.click();
  };
  // The file chooser of the browser is one click, too.
  clicks++;
  await openField(page, smallField(server.folder));
  await click(page.getByRole('button', { name: 'Plan this field' }));
  clicks++;
  await makePlan(page);
  clicks++;
  await page.getByLabel('Which display?').selectOption('claas');
  assert.match(await panel(page).innerText(), /a folder TASKDATA has to lie there/);
  const zip = await saved(page, () => click(page.getByRole('button', { name: 'Task set, ISOXML 4' })), server.folder);
  assert.ok(clicks <= 6, `${clicks} clicks`);
  assert.ok(entries(zip).includes('TASKDATA/TASKDATA.XML'), entries(zip).join());

  // Byte for byte what the program exports, but for where it was written.
  const plan = join(server.folder, 'plans', `${openId(page, 'plan')}.gpkg`);
  execFileSync(tramline, ['export', plan, '-o', join(server.folder, 'own.zip'), '--isoxml', '4', '--quiet']);
  assert.equal(entry(zip, 'TASKDATA/TASKDATA.XML'), entry(join(server.folder, 'own.zip'), 'TASKDATA/TASKDATA.XML'));

  // The choice is kept, and a display that is typed into gets a card.
  await page.reload();
  await page.getByRole('button', { name: 'Task set, ISOXML 4' }).waitFor();
  await page.getByLabel('Which display?').selectOption('typed');
  const card = await saved(page, () => page.getByRole('button', { name: 'Line card, PDF' }).click(), server.folder);
  assert.equal(readFileSync(card).subarray(0, 5).toString(), '%PDF-');

  // A drone flies as high as it is told.
  await page.getByLabel('Which display?').selectOption('qgc');
  await page.getByLabel('Altitude of a drone').fill('3');
  const mission = JSON.parse(readFileSync(await saved(page, () => page.getByRole('button', { name: 'Mission, .plan' }).click(), server.folder), 'utf8'));
  assert.ok(mission.mission.items.some(({ Altitude, params }) => Altitude === 3 || params?.[6] === 3), 'an item at 3 m');

  // Only this computer is served: the phone is told how.
  await page.getByRole('button', { name: 'Open it on the phone' }).click();
  await page.getByText(/tramline serve --host 0\.0\.0\.0/).waitFor();
  assert.equal(await page.locator('svg.code').count(), 0);
});

flow('tracks alone have no route to take along', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await goTo(page, 'Plan');
  await page.getByRole('radio', { name: 'Tracks, by prices' }).evaluate((radio) => radio.click());
  await makePlan(page);
  await page.getByLabel('Which display?').selectOption('ros');
  assert.match(await panel(page).innerText(), /This plan is of tracks alone/);
  assert.equal(await page.getByRole('button', { name: 'Route, YAML' }).count(), 0);
});
