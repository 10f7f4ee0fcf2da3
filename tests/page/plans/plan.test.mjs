// From a file with a field to a plan that leaves the program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { flow, long, realFile } from '../support/flow.mjs';
import { clickMap, drawn, figure, goTo, makePlan, newPlan, openField, panel, planTracks, visible } from '../support/page.mjs';
import { example, tramline } from '../support/server.mjs';

const check = (file, field) => execFileSync(tramline, ['check', file, ...(field ? ['--field', field] : [])], { encoding: 'utf8' });

async function download(page, name, folder) {
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('link', { name }).click()]);
  const path = join(folder, file.suggestedFilename());
  await file.saveAs(path);
  return path;
}

/** What a plan has to do with its figures, whatever the field. */
async function planCompareExport({ page, server }, field) {
  await planTracks(page);
  await page.getByLabel('Working width', { exact: true }).fill('24');
  await page.getByLabel('Swaths end at a slanting edge').selectOption('inside');
  await makePlan(page);
  assert.ok((await drawn(page, 'plan:tracks')) > 0, 'tracks are on the map');
  const [overlap, uncovered] = [await figure(page, 'Overlap'), await figure(page, 'Uncovered')];

  const hash = new URL(page.url()).hash;
  await page.getByLabel('Swaths end at a slanting edge').selectOption('cover');
  await newPlan(page, hash);
  // Covering everything at slanting edges leaves less and overlaps more than staying inside.
  assert.ok((await figure(page, 'Uncovered')) < uncovered, 'less is left out');
  assert.ok((await figure(page, 'Overlap')) > overlap, 'more is worked twice');

  await goTo(page, 'Compare');
  await page.getByRole('button', { name: 'Find the plans' }).click();
  const dots = page.locator('.dot');
  await dots.first().waitFor({ timeout: 120_000 });
  const many = await dots.count();
  assert.ok(many >= 1);
  await dots.last().hover({ force: true });
  await page.locator('.about strong').waitFor();
  const before = new URL(page.url()).hash;
  await dots.last().click({ force: true });
  await newPlanInAddress(page, before);
  assert.match(await panel(page).innerText(), /Why the plan on the map/);
  const table = page.getByRole('region', { name: 'Differences of the two plans' });
  await table.waitFor();
  assert.match(await table.innerText(), /Overlap[^\n]*m²/);

  await goTo(page, 'Plan');
  const file = await download(page, /GeoPackage/, server.folder);
  assert.match(check(file, field), /the plan holds|holds/i);
}

async function newPlanInAddress(page, before) {
  const old = new URLSearchParams(before.slice(1)).get('plan');
  await page.waitForFunction((was) => new URLSearchParams(location.hash.slice(1)).get('plan') !== was, old, { timeout: 60_000 });
}

flow('a field with holes: plan, end rule, compare, export, check', {}, async (context) => {
  const { page } = context;
  await openField(page, example('riverside.geojson'));
  const text = await panel(page).innerText();
  assert.match(text, /12\.13 ha · 7 obstacles/);
  assert.match(text, /Mended: outer ring had vertex 4/);
  assert.ok((await drawn(page, 'obstacle')) > 0, 'obstacles are on the map');
  await planCompareExport(context, example('riverside.geojson'));
});

flow('several fields: choose one, go back to it after a reload', { skip: long }, async ({ page }) => {
  await page.getByLabel('Choose a file with a field').setInputFiles(example('two-farms.gpkg'));
  await page.getByRole('heading', { name: /Which field of two-farms\.gpkg/ }).waitFor();
  const cards = page.locator('.cards .card');
  assert.ok((await cards.count()) >= 4);
  assert.ok((await page.locator('.preview path').count()) >= 4, 'each has its preview');
  await page.getByRole('button', { name: /barrow-field/ }).click();
  await page.getByRole('region', { name: /^Open field/ }).waitFor();
  await page.reload();
  await page.getByRole('region', { name: /^Open field/ }).waitFor();
});

flow('every file can be taken away', { skip: long }, async ({ page, server }) => {
  await openField(page, example('terrace.kml'));
  await planTracks(page);
  await makePlan(page);
  for (const name of [/GeoPackage/, /GeoJSON/, /KML/, /Shapefiles/, /FlatGeobuf/, /Picture/, /Drawing/, /Sheet/]) {
    const file = await download(page, name, server.folder);
    const size = Number(execFileSync('stat', ['-c', '%s', file], { encoding: 'utf8' }));
    assert.ok(size > 500, `${file} has ${size} bytes`);
  }
});

flow('layers are switched on and off, with their sizes beside them', { skip: long }, async ({ page }) => {
  await openField(page, example('riverside.geojson'));
  await planTracks(page);
  await page.getByLabel('Headland passes').fill('1');
  await makePlan(page);
  for (const [label, layer] of [['Overlap', 'plan:overlap'], ['Tracks', 'plan:tracks'], ['Headland passes', 'plan:headland_passes']]) {
    const row = page.locator('.legend .switch', { hasText: new RegExp(`^${label}`) });
    assert.match(await row.locator('.number').innerText(), /\d (m²|m|km|ha)$/);
    assert.equal(await visible(page, layer), true);
    await row.getByRole('switch').uncheck({ force: true });
    assert.equal(await visible(page, layer), false);
    await row.getByRole('switch').check({ force: true });
  }
  const swaths = page.locator('.legend .switch', { hasText: /^Swaths/ });
  assert.equal(await visible(page, 'plan:swaths'), false);
  await swaths.getByRole('switch').check({ force: true });
  await page.waitForFunction(() => window.tramlineMap.getLayoutProperty('plan:swaths', 'visibility') === 'visible');
  assert.ok((await drawn(page, 'plan:swaths')) > 0);
});

flow('tracks along an edge of the field, picked from the list', { skip: long }, async ({ page }) => {
  await openField(page, example('roadside.geojson'));
  await planTracks(page);
  await makePlan(page);
  const edge = page.getByLabel('Parallel to');
  const label = await edge.locator('option', { hasText: /^edge 2:/ }).innerText();
  const towards = Number(/towards ([\d.]+)°/.exec(label)[1]) % 180;
  const hash = new URL(page.url()).hash;
  await edge.selectOption({ label });
  await newPlan(page, hash);
  const direction = Number(/tracks towards ([\d.]+)°/.exec(await panel(page).innerText())[1]);
  const off = Math.abs(((direction - towards + 270) % 180) - 90);
  assert.ok(off < 0.3, `tracks towards ${direction}°, the edge ${towards}°`);
});

/** The rows of a table by their first cell: count, length and time of a kind of legs. */
const rowsOf = (page, name) =>
  page.getByRole('table', { name }).locator('tbody tr').evaluateAll((rows) => Object.fromEntries(rows.map((row) => [row.cells[0].innerText.trim(), [...row.cells].slice(1).map((cell) => cell.innerText)])));

/** "1,234 m" → 1234, "12.3 km" → 12300. */
const inMetres = (text) => Number(text.replace(/[^\d.]/g, '')) * (text.includes('km') ? 1000 : 1);

flow('the whole route: legs by kind on the map, their sums, a gate', {}, async ({ page }) => {
  await openField(page, example('terrace.kml'));
  await planTracks(page);
  await page.getByLabel('Headland passes').fill('2');
  await page.getByRole('switch', { name: /^Plan every metre/ }).check({ force: true });
  await makePlan(page);
  const rows = await rowsOf(page, 'The route');
  assert.ok(['Tracks', 'Headland passes', 'All'].every((row) => row in rows), Object.keys(rows).join());
  const parts = Object.entries(rows).filter(([name]) => name !== 'All').map(([, cells]) => cells);
  assert.equal(parts.reduce((sum, [legs]) => sum + Number(legs.replace(',', '')), 0), Number(rows.All[0].replace(',', '')), 'legs of all kinds are all legs');
  const whole = inMetres(rows.All[1]);
  assert.ok(Math.abs(parts.reduce((sum, [, metres]) => sum + inMetres(metres), 0) - whole) < 0.02 * whole, JSON.stringify(rows));
  assert.ok((await drawn(page, 'plan:route-forward')) > 0, 'ways between tracks are on the map');
  assert.equal(await drawn(page, 'plan:route-ends'), 2);
  const kinds = await page.evaluate(() => [...new Set(window.tramlineMap.queryRenderedFeatures({ layers: ['plan:route-forward'] }).map((leg) => leg.properties.kind))]);
  assert.ok(kinds.every((kind) => ['turn', 'transit', 'back_out'].includes(kind)), kinds.join());
  const row = page.locator('.legend .switch', { hasText: /^Route/ });
  await row.getByRole('switch').uncheck({ force: true });
  assert.equal(await visible(page, 'plan:route-ends'), false);
  await row.getByRole('switch').check({ force: true });

  const gate = await page.evaluate(() => window.tramlineMap.getCenter().toArray());
  const hash = new URL(page.url()).hash;
  await page.getByRole('button', { name: 'Set the start on the map' }).click();
  await clickMap(page, gate);
  await page.getByRole('button', { name: 'Take this place' }).click();
  await newPlan(page, hash);
  // The map takes a moment to show it, and rounds places to its tiles.
  await page.waitForFunction(
    ([lon, lat]) => {
      const shown = window.tramlineMap.querySourceFeatures('plan:route_ends').filter((end) => end.properties.end === 'start');
      const off = ({ geometry: { coordinates } }) => Math.hypot((coordinates[0] - lon) * Math.cos((lat * Math.PI) / 180), coordinates[1] - lat) * 111_000;
      return shown.some((end) => off(end) < 2);
    },
    gate, { timeout: 20_000 },
  );
});

const real = realFile('fields', 'fields.geojson');
flow('a real field: plan, end rule, compare, export, check', { skip: long || real.skip }, async (context) => {
  const { page } = context;
  await page.getByLabel('Choose a file with a field').setInputFiles(real.file);
  await page.getByRole('heading', { name: /Which field/ }).waitFor();
  // Only the rows in sight exist.
  const list = page.getByRole('region', { name: 'Fields of the file' });
  const withObstacle = list.locator('.card:not([disabled])', { hasText: 'obstacle' });
  for (let i = 0; i < 200 && (await withObstacle.count()) === 0; ++i) {
    await list.evaluate((rows) => rows.scrollBy(0, rows.clientHeight));
    await page.waitForTimeout(50);
  }
  await withObstacle.first().click();
  await page.getByRole('region', { name: /^Open field/ }).waitFor();
  await planCompareExport(context, null);
});
