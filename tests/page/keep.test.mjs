// What is kept, under which name, and for how long.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { flow } from './support/flow.mjs';
import { chooseFile, figure, goTo, makePlan, newPlan, openField, panel, planTracks } from './support/page.mjs';
import { example, tramline } from './support/server.mjs';

const ask = async (server, path) => (await fetch(`${server.address}/api/v1${path}`)).json();
const openId = (page, what) => new URLSearchParams(new URL(page.url()).hash.slice(1)).get(what);

/** Changes a control and waits for the plan that is made of it by itself. */
async function change(page, label, value) {
  const hash = new URL(page.url()).hash;
  await page.getByLabel(label, { exact: true }).fill(value);
  await newPlan(page, hash);
}

/** A file with so many square fields of different sizes in a row. */
function manyFields(folder, many) {
  const features = Array.from({ length: many }, (_, i) => {
    const [west, south, side] = [9 + i * 0.01, 50, 0.001 + i * 0.0001];
    const ring = [[west, south], [west + side, south], [west + side, south + side], [west, south + side], [west, south]];
    return { type: 'Feature', properties: { id: `${i % 2 ? 'Ödland' : 'meadow'}-${i}` }, geometry: { type: 'Polygon', coordinates: [ring] } };
  });
  const file = join(folder, 'many.geojson');
  writeFileSync(file, JSON.stringify({ type: 'FeatureCollection', features }));
  return file;
}

flow('many fields in a file: search, by keyboard too, and store several at once', {}, async ({ page, server }) => {
  await chooseFile(page, 'Choose a file with a field', manyFields(server.folder, 30));
  const search = page.getByLabel('Search by name, area or any other attribute');
  await search.waitFor();
  const cards = page.locator('#features .card');
  assert.equal(await cards.count(), 30);
  await search.fill('OD odland-1'); // case, accents and the order of words do not matter
  assert.deepEqual(await cards.locator('strong').allInnerTexts(), [1, 11, 13, 15, 17, 19].map((i) => `Ödland-${i}`));
  assert.match(await panel(page).innerText(), /6 of 30 fields/);
  await search.fill('nothing like this');
  assert.equal(await cards.count(), 0);
  assert.match(await panel(page).innerText(), /None of 30 fields has these words/);
  await page.keyboard.press('Escape');
  assert.equal(await cards.count(), 30);
  await search.fill('ödland-2');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  assert.equal(await page.evaluate(() => document.activeElement.querySelector('strong')?.textContent), 'Ödland-23');

  await page.getByLabel('All 5 that were found').check();
  await search.fill('');
  await page.getByLabel('Tick meadow-0').check();
  await page.getByRole('button', { name: 'Store 6 fields' }).click();
  await page.getByText('Stored: 6 fields of many.geojson').waitFor();
  const names = (await ask(server, '/fields')).map((field) => field.name).sort();
  assert.deepEqual(names, ['meadow-0', 'Ödland-21', 'Ödland-23', 'Ödland-25', 'Ödland-27', 'Ödland-29']);
});

flow('a long list of stored fields has a search, too', {}, async ({ page, server }) => {
  await chooseFile(page, 'Choose a file with a field', manyFields(server.folder, 12));
  await page.getByLabel('All 12 fields').check();
  await page.getByRole('button', { name: 'Store 12 fields' }).click();
  await page.getByText('Stored: 12 fields of many.geojson').waitFor();
  await page.getByLabel('Search by name, crop, tag or area').fill('meadow 10');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await page.getByRole('region', { name: 'Open field: meadow-10' }).waitFor();
});

flow('plans made on the way replace one another, and those that are wanted stay', {}, async ({ page, server }) => {
  await openField(page, example('terrace.kml'));
  await planTracks(page);
  await makePlan(page);
  const asked = openId(page, 'plan');
  const field = openId(page, 'field');
  const ids = async () => (await ask(server, `/plans?field=${field}`)).map((plan) => plan.id);
  await change(page, 'Working width', '5');
  const first = openId(page, 'plan');
  await change(page, 'Working width', '4');
  const second = openId(page, 'plan');
  assert.deepEqual(new Set(await ids()), new Set([asked, second]), 'the first draft is gone');
  assert.match(await panel(page).innerText(), /A draft: the next change replaces it/);
  await page.getByRole('button', { name: 'Keep it' }).click();
  await page.getByText('A draft:').waitFor({ state: 'detached' });
  await change(page, 'Working width', '3');
  assert.ok((await ids()).includes(second), 'what was kept stays');
  assert.ok(!(await ids()).includes(first));

  // A name, a download and a look beside another plan keep it, too.
  const named = openId(page, 'plan');
  await page.getByLabel('Name of the plan').fill('spring');
  await page.keyboard.press('Enter');
  await page.getByText('A draft:').waitFor({ state: 'detached' });
  await change(page, 'Turning radius', '5');
  const taken = openId(page, 'plan');
  await Promise.all([page.waitForEvent('download'), page.getByRole('link', { name: /GeoJSON/ }).click()]);
  await page.getByText('A draft:').waitFor({ state: 'detached' });
  await change(page, 'Turning radius', '4');
  const beside = openId(page, 'plan');
  await goTo(page, 'Compare');
  await page.getByRole('region', { name: 'Differences of the two plans' }).waitFor();
  await goTo(page, 'Plan');
  await change(page, 'Turning radius', '3');
  assert.deepEqual(new Set(await ids()), new Set([asked, second, named, taken, beside, openId(page, 'plan')]));
  assert.equal((await ask(server, `/plans/${named}`)).name, 'spring');
});

flow('a plan is renamed and deleted', {}, async ({ page, server }) => {
  await openField(page, example('terrace.kml'));
  await planTracks(page);
  await makePlan(page);
  const plan = openId(page, 'plan');
  await page.getByLabel('Name of the plan').fill('first cut');
  await page.keyboard.press('Enter');
  await page.getByRole('region', { name: 'Open plan: first cut' }).waitFor();
  assert.equal((await ask(server, `/plans/${plan}`)).name, 'first cut');
  await page.getByRole('button', { name: 'Delete the plan first cut' }).click();
  await page.getByRole('button', { name: 'Delete it' }).click();
  await page.getByText('The plan is deleted.').waitFor();
  await page.getByRole('button', { name: 'Make the plan' }).waitFor();
  assert.equal((await ask(server, '/plans')).length, 0);
});

flow('a plan is checked, and the verdict has its numbers', {}, async ({ page, server }) => {
  await openField(page, example('riverside.geojson'));
  await planTracks(page);
  await makePlan(page);
  await page.getByRole('button', { name: 'Check this plan' }).click();
  await page.getByText('The plan holds:').waitFor({ timeout: 60_000 });
  // The same from the command line, of the same file.
  const file = join(server.folder, 'plans', `${openId(page, 'plan')}.gpkg`);
  const { recomputed } = JSON.parse(execFileSync(tramline, ['check', file, '--json'], { encoding: 'utf8' }));
  const row = page.getByRole('row', { name: /^Overlap/ });
  const found = Number((await row.locator('td').last().innerText()).replace(/[^\d.]/g, ''));
  assert.ok(Math.abs(found - recomputed.overlap_m2) <= 0.5, `${found} m², ${recomputed.overlap_m2} m²`);
  assert.equal(Number(await page.getByRole('row', { name: /^Turns/ }).locator('td').last().innerText()), recomputed.turns);
});

flow('a plan that does not hold says where', {}, async ({ page, server }) => {
  await openField(page, example('riverside.geojson'));
  await planTracks(page);
  await makePlan(page);
  const file = join(server.folder, 'plans', `${openId(page, 'plan')}.gpkg`);
  // A plan from elsewhere whose file says less overlap than there is.
  execFileSync('python3', ['-c', `
import sqlite3, sys
db = sqlite3.connect(sys.argv[1])
db.execute("update metadata set value = '1.5' where key = 'tally.overlap_m2'")
assert db.total_changes == 1, db.execute('select key from metadata').fetchall()
db.commit()`, file]);
  await page.getByRole('button', { name: 'Check this plan' }).click();
  await page.getByText('The plan does not hold').waitFor({ timeout: 60_000 });
  assert.match(await panel(page).innerText(), /overlap/i);
  const zoom = await page.evaluate(() => window.tramlineMap.getZoom());
  await page.getByRole('button', { name: 'Show place 1 on the map' }).click();
  await page.waitForFunction((was) => window.tramlineMap.getZoom() !== was, zoom);
});

flow('a machine is stored, renamed, replaced and deleted', {}, async ({ page, server }) => {
  await openField(page, example('terrace.kml'));
  await planTracks(page);
  await page.getByLabel('Working width', { exact: true }).fill('24');
  await page.getByText('More about the machine').click();
  await page.getByLabel('Store this machine under a name').fill('sprayer');
  await page.getByRole('button', { name: 'Store', exact: true }).click();
  await page.getByText('sprayer is stored').waitFor();
  await page.getByLabel('Name of the stored machine').fill('big sprayer');
  await page.keyboard.press('Enter');
  await page.locator('option', { hasText: 'big sprayer, 24 m' }).waitFor({ state: 'attached' });
  await page.getByLabel('Working width', { exact: true }).fill('27');
  await page.getByLabel('Store this machine under a name').fill('big sprayer');
  await page.getByRole('button', { name: 'Replace' }).click();
  await page.getByText('big sprayer is changed').waitFor();
  const [machine, ...others] = await ask(server, '/machines');
  assert.deepEqual([machine.name, machine.width_m, others.length], ['big sprayer', 27, 0]);
  await page.getByRole('button', { name: 'Delete the machine big sprayer' }).click();
  await page.getByRole('button', { name: 'Delete it' }).click();
  await page.getByText('big sprayer is deleted').waitFor();
  assert.equal((await ask(server, '/machines')).length, 0);
  assert.equal(await page.getByLabel('Working width', { exact: true }).inputValue(), '27', 'the form stays as it is');
});

flow('a field and a drive are renamed, and deleted', {}, async ({ page, server }) => {
  await openField(page, example('riverside.geojson'));
  await page.getByLabel('Name of the field').fill('river meadow');
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: /^river meadow/ }).waitFor();
  await goTo(page, 'Review');
  await chooseFile(page, 'Choose the log of a machine', example('riverside-drive.csv'));
  await page.getByRole('button', { name: 'Show what was worked' }).click();
  await page.getByLabel('Name of the drive').fill('second of May');
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: /^second of May/ }).waitFor();
  assert.equal((await ask(server, '/drives'))[0].name, 'second of May');
  assert.ok((await figure(page, 'Covered')) > 10, 'the drive is still open');
  await page.getByRole('button', { name: 'Delete second of May' }).click();
  await page.getByRole('button', { name: 'Delete it' }).click();
  await page.getByText('None yet. Choose a log').waitFor();
  await goTo(page, 'Fields');
  await page.getByRole('button', { name: 'Delete river meadow' }).click();
  await page.getByRole('button', { name: 'Delete it' }).click();
  await page.getByText('The field is deleted.').waitFor();
});
