// The farm: all fields on one map, found by crop and tag, several planned at once.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { flow } from '../support/flow.mjs';
import { clickMap, drawn, panel, still } from '../support/page.mjs';
import { ask, polygonOf } from '../support/stored.mjs';

const CROPS = ['barley', 'wheat', 'barley', 'oats'];
const feature = (i, west, south) => ({ type: 'Feature', properties: { name: `field ${i}`, crop: CROPS[i % 4] }, geometry: polygonOf('slant', west, south) });

async function storeAll(page, server, many, across) {
  const features = Array.from({ length: many }, (_, i) => feature(i, 9 + (i % across) * 0.004, 50 + Math.floor(i / across) * 0.003));
  const file = join(server.folder, 'farm.geojson');
  writeFileSync(file, JSON.stringify({ type: 'FeatureCollection', features }));
  await page.getByLabel('Choose a file with a field').setInputFiles(file);
  await page.getByLabel(`All ${many} fields`).check();
  await page.getByRole('button', { name: `Store ${many} fields` }).click();
  await page.getByText(`Stored: ${many} fields of farm.geojson`).waitFor({ timeout: 120_000 });
}

flow('fields on one map, with crop and tags; several are planned at once', {}, async ({ page, server }) => {
  await storeAll(page, server, 4, 2);
  await page.getByRole('button', { name: 'Show the whole field' }).click();
  await still(page);
  assert.ok((await drawn(page, 'farm')) >= 4); // parts of one field in several tiles count each
  assert.match(await panel(page).innerText(), /field 1\s+1\.47 ha · wheat\s+not planned/);

  await clickMap(page, [9.005, 50.0005]); // the one to the east
  await page.getByRole('region', { name: 'Open field: field 1' }).waitFor();
  await page.getByLabel('Tags', { exact: true }).fill('rented, hill');
  await page.keyboard.press('Tab');
  await page.getByText('#rented · #hill').waitFor();
  await page.getByLabel('Crop', { exact: true }).fill('rye');
  await page.keyboard.press('Tab');
  await page.getByText(/· rye ·/).waitFor();
  const stored = (await ask(server, '/fields')).find(({ name }) => name === 'field 1');
  assert.deepEqual([stored.crop, stored.tags], ['rye', ['rented', 'hill']]);

  await page.getByLabel('Tick field 0').check();
  await page.getByLabel('Tick field 2').check();
  await page.getByRole('button', { name: 'Plan 2 fields' }).click();
  await page.getByText('Planned: 2 fields.').waitFor({ timeout: 120_000 });
  const list = await ask(server, '/fields');
  const hours = list.filter(({ last_plan }) => last_plan).map(({ last_plan }) => last_plan.hours);
  assert.equal(hours.length, 2);
  assert.ok(hours.every((h) => h > 0.1));
  const sum = hours.reduce((a, b) => a + b, 0).toFixed(2);
  assert.ok((await panel(page).innerText()).includes(`2 fields planned as a whole: ${sum} h`), sum);
  // Opened, a field shows its plan.
  await page.getByRole('button', { name: /^field 0/ }).click();
  await page.waitForFunction((id) => location.hash.includes(`plan=${id}`), list.find(({ name }) => name === 'field 0').last_plan.id);
});

const MANY = process.env.TRAMLINE_LONG ? 300 : 70;
flow('a farm of many fields: rows in sight only, found by tag and crop', {}, async ({ page, server }) => {
  await storeAll(page, server, MANY, 15);
  assert.ok((await page.locator('#stored-fields .card').count()) < 50, 'rows in sight only');
  await page.getByLabel('Search by name, crop, tag or area').fill('oats');
  assert.match(await panel(page).innerText(), new RegExp(`${Math.floor(MANY / 4)} of ${MANY} fields`));
  await page.getByRole('button', { name: 'Show the whole field' }).click();
  await still(page);
  // Parts of one field in several tiles count each.
  const shown = await page.evaluate(() => new Set(window.tramlineMap.queryRenderedFeatures({ layers: ['farm'] }).map((f) => f.properties.id)).size);
  assert.equal(shown, MANY);
});
