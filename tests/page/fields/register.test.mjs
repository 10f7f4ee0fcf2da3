// Files with many fields: registers, Shapefiles in parts, task sets.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { flow, realFile } from '../support/flow.mjs';
import { clickMap, drawn, goTo, mapSettled, panel } from '../support/page.mjs';
import { ask, polygonOf, smallField } from '../support/stored.mjs';
import { example } from '../support/server.mjs';

/** 39,200 with TRAMLINE_LONG, as many as a district has; else enough for the same road through the page. */
const MANY = process.env.TRAMLINE_LONG ? 39_200 : 3_000;
const ACROSS = 200;
const CROPS = ['barley', 'wheat', 'grass', 'maize'];

/** Parcels in rows, with the columns of a register. */
function register(folder) {
  const features = Array.from({ length: MANY }, (_, i) => {
    const [west, south, size] = [9 + (i % ACROSS) * 0.003, 50 + Math.floor(i / ACROSS) * 0.003, 0.001 + (i % 7) * 0.0002];
    const ring = [[west, south], [west + size, south], [west + size, south + size], [west, south + size], [west, south]];
    return { type: 'Feature', properties: { FLIK: `DEXX${100_000 + i}`, crop: CROPS[i % 4], farm: `farm${i % 50}x` }, geometry: { type: 'Polygon', coordinates: [ring] } };
  });
  const file = join(folder, 'register.geojson');
  writeFileSync(file, JSON.stringify({ type: 'FeatureCollection', features }));
  return file;
}
const choose = (page, files) => page.getByLabel('Choose a file with a field').setInputFiles(files);
const names = (page) => page.locator('#features strong').allInnerTexts();

flow('a whole register: rows in sight only, searched by any attribute, sorted, ticked on the map', {}, async ({ page, server }) => {
  await choose(page, register(server.folder));
  const search = page.getByLabel('Search by name, area or any other attribute');
  await search.waitFor({ timeout: 120_000 });
  assert.match(await panel(page).innerText(), new RegExp(`${MANY.toLocaleString('en-GB')} fields`));
  assert.ok((await page.locator('#features .card').count()) < 60, 'only rows in sight exist');
  assert.equal((await names(page))[0], 'DEXX100000', 'the number in the register names a field');

  await search.fill('FARM7x maize');
  await page.waitForFunction(() => /of [\d,]+ fields/.test(document.querySelector('main').innerText));
  const expected = Array.from({ length: MANY }, (_, i) => i).filter((i) => CROPS[i % 4] === 'maize' && i % 50 === 7);
  assert.match(await panel(page).innerText(), new RegExp(`${expected.length.toLocaleString('en-GB')} of`));
  await page.getByLabel('In the order of').selectOption('large');
  const areas = (await page.locator('#features .sub').allInnerTexts()).map((text) => Number(/^([\d.]+) ha/.exec(text)[1]));
  assert.ok(areas.length > 3 && areas.every((area, i) => i === 0 || area <= areas[i - 1]), areas.join());

  await search.fill('');
  // Down to the end of the list, where the smallest are.
  await page.getByRole('region', { name: 'Fields of the file' }).evaluate((list) => list.scrollTo(0, list.scrollHeight));
  await page.waitForFunction((last) => [...document.querySelectorAll('#features .sub')].some((row) => new RegExp(last).test(row.textContent)), '^0\\.[78]');

  await search.fill('DEXX100201');
  await page.waitForFunction(() => document.querySelectorAll('#features .card').length === 1);
  await mapSettled(page);
  assert.ok((await drawn(page, 'choosing')) >= 1, 'it is on the map');
  const i = 201;
  await clickMap(page, [9 + (i % ACROSS) * 0.003 + 0.0004, 50 + Math.floor(i / ACROSS) * 0.003 + 0.0004]);
  await page.getByRole('button', { name: 'Store 1 field' }).waitFor();
  await page.locator('#features .card').click();
  await page.getByRole('region', { name: 'Open field: DEXX100201' }).waitFor();
  assert.equal((await ask(server, '/fields'))[0].name, 'DEXX100201');
});

flow('fields are called as people call them', {}, async ({ page, server }) => {
  await choose(page, example('terrace.kml'));
  await page.getByRole('region', { name: 'Open field: terrace' }).waitFor();
  await choose(page, smallField(server.folder));
  await page.getByRole('region', { name: 'Open field: slant field' }).waitFor();
  const nameless = join(server.folder, 'Long Acre.geojson');
  writeFileSync(nameless, JSON.stringify({ type: 'FeatureCollection', features: [{ type: 'Feature', properties: {}, geometry: polygonOf('slant') }] }));
  await choose(page, nameless);
  await page.getByRole('region', { name: 'Open field: Long Acre' }).waitFor();
});

/** A task set of one partfield with a designator and no log. */
function taskSet(folder) {
  const points = polygonOf('slant').coordinates[0].map(([lon, lat]) => `<PNT A="2" C="${lat}" D="${lon}"/>`).join('');
  const file = join(folder, 'TASKDATA.XML');
  writeFileSync(file, `<?xml version="1.0" encoding="UTF-8"?>
<ISO11783_TaskData VersionMajor="4" VersionMinor="0" DataTransferOrigin="1">
<PFD A="PFD-1" C="Mill Field" D="16000"><PLN A="1"><LSG A="1">${points}</LSG></PLN></PFD>
</ISO11783_TaskData>`);
  return file;
}

flow('a task set without logs opens its fields from either view', {}, async ({ page, server }) => {
  await choose(page, taskSet(server.folder));
  await page.getByRole('region', { name: 'Open field: Mill Field' }).waitFor();
  await goTo(page, 'Review');
  await page.getByLabel('Choose the log of a machine').setInputFiles(taskSet(server.folder));
  await page.getByText('has no log. Its fields are here.').waitFor();
  await page.waitForFunction(() => location.hash.includes('view=fields'));
  assert.equal((await ask(server, '/fields')).length, 2);
});

const logs = realFile('isoxml', 'forage-harvester', 'TASKDATA');
flow('a task set with logs opens its fields, too', { skip: logs.skip }, async ({ page }) => {
  await choose(page, readdirSync(logs.file).map((name) => join(logs.file, name)));
  await page.getByRole('heading', { name: /Which field/ }).waitFor({ timeout: 60_000 });
  const found = await names(page);
  assert.ok(found.length > 0 && found.every((name) => !/^partfields:/.test(name)), found.join());
});

const ogr2ogr = '/usr/bin/ogr2ogr';
flow('the parts of a Shapefile are chosen together', { skip: existsSync(ogr2ogr) ? false : 'no ogr2ogr' }, async ({ page, server }) => {
  execFileSync(ogr2ogr, [join(server.folder, 'parts.shp'), smallField(server.folder)]);
  await choose(page, ['shp', 'shx', 'dbf', 'prj'].map((extension) => join(server.folder, `parts.${extension}`)));
  await page.getByRole('region', { name: 'Open field: slant field' }).waitFor();
});
for (const [file, name] of [['nl-brp-2023.gpkg', /, field \d+$/], ['dk-marker.zip', /^\d+-\d/], ['de-sh-feldbloecke.zip', /^DESH/]]) {
  const real = realFile('registers', file);
  flow(`the register ${file} names its parcels`, { skip: real.skip }, async ({ page }) => {
    await choose(page, real.file);
    await page.getByRole('heading', { name: /Which field/ }).waitFor({ timeout: 60_000 });
    const found = await names(page);
    assert.ok(found.length > 5 && found.every((one) => name.test(one) && !/^\w+:\d+$/.test(one)), found.slice(0, 5).join());
  });
}
