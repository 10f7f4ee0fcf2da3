// A machine at work: what the cab shows, and what becomes of it when the server is started again.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { flow } from './support/flow.mjs';
import { chooseFile, goTo, makePlan, openField, panel, planTracks, visible } from './support/page.mjs';
import { example } from './support/server.mjs';
import { ask } from './support/stored.mjs';
import { startTractor } from './support/tractor.mjs';

async function watch(page, tractor, width_m = null) {
  await goTo(page, 'Review');
  await page.getByText('Watch a machine at work').click();
  await page.getByLabel('Host and port').fill(`127.0.0.1:${tractor.port}`);
  if (width_m !== null) await page.getByLabel('Working width').last().fill(String(width_m));
  await page.getByRole('button', { name: 'Watch it' }).click();
  await page.getByLabel('Worked so far').waitFor({ timeout: 30_000 });
}

flow('the cab shows speed, work and the way to the line; land still to do is not missed', {}, async ({ page }) => {
  const tractor = await startTractor(example('riverside-drive.csv'), { per_s: 40, most: 1500 });
  try {
    await openField(page, example('riverside.geojson'));
    await planTracks(page);
    await makePlan(page);
    await watch(page, tractor);
    const cab = page.getByLabel('In the cab');
    await page.waitForFunction(() => /Speed\s*[\d.]+ km\/h/.test(document.querySelector('.cab')?.innerText ?? ''));
    const speed = Number(/([\d.]+) km\/h/.exec(await cab.innerText())[1]);
    assert.ok(speed > 1 && speed < 40, `${speed} km/h`);
    await page.waitForFunction(() => /Off (track \d+|the line)\s*[\d.]+ m/.test(document.querySelector('.cab')?.innerText ?? ''), null, { timeout: 40_000 });
    const text = await panel(page).innerText();
    assert.match(text, /Still to do/);
    assert.doesNotMatch(text, /Missed/);
    assert.equal(await visible(page, 'plan:tracks'), true, 'the lines to follow are on the map');
    assert.equal(await visible(page, 'field-missed'), false);
  } finally {
    await tractor.stop();
  }
});

flow('the map stays over the machine while it follows, and stays where it was put when not', {}, async ({ page }) => {
  const tractor = await startTractor(example('riverside-drive.csv'), { per_s: 60 });
  try {
    await openField(page, example('riverside.geojson'));
    await watch(page, tractor);
    /** Where the map looks, once a machine is drawn. */
    const seen = () => page.evaluate(async () => {
      const map = window.tramlineMap;
      const at = (await map.getSource('work:machine').getData()).features[0]?.geometry.coordinates;
      return at ? { centre: map.getCenter().toArray() } : null;
    });
    const until = (what) => page.waitForFunction(what, null, { timeout: 20_000 });
    const follow = page.getByRole('switch', { name: 'Keep the machine in the middle of the map' });
    await follow.setChecked(true, { force: true });
    await until(async () => (await window.tramlineMap.getSource('work:machine').getData()).features.length > 0);
    // The machine moves with its data, the map with the next frame.
    const inTheMiddle = () => until(async () => {
      const map = window.tramlineMap;
      const at = (await map.getSource('work:machine').getData()).features[0].geometry.coordinates;
      const [p, q] = [map.project(at), map.project(map.getCenter())];
      return Math.hypot(p.x - q.x, p.y - q.y) < 2;
    });
    await inTheMiddle();
    const first = await seen();
    // Not from where the machine was: that may have been before the last frame.
    await page.evaluate((was) => { window.wasAt = was; }, first.centre);
    await until(async () => {
      const [x, y] = (await window.tramlineMap.getSource('work:machine').getData()).features[0].geometry.coordinates;
      return Math.hypot((x - window.wasAt[0]) * 70_000, (y - window.wasAt[1]) * 111_000) > 10;
    });
    await inTheMiddle();
    const then = await seen();
    assert.ok(then.centre.join() !== first.centre.join(), 'the map went along');

    await follow.setChecked(false, { force: true });
    await page.evaluate(() => { const map = window.tramlineMap; map.jumpTo({ zoom: map.getZoom() - 2 }); window.wasAt = map.getCenter().toArray(); });
    await until(async () => {
      const [x, y] = (await window.tramlineMap.getSource('work:machine').getData()).features[0].geometry.coordinates;
      return Math.hypot((x - window.wasAt[0]) * 70_000, (y - window.wasAt[1]) * 111_000) > 10;
    });
    const free = await seen();
    assert.deepEqual(free.centre, await page.evaluate(() => window.wasAt), 'it stays where it is');
  } finally {
    await tractor.stop();
  }
});

/** Sentences of a receiver that drives north beside 9.15° E, once with RTK and then without corrections. */
function nmeaLog(folder) {
  const sentence = (body) => `$${body}*${[...body].reduce((sum, c) => sum ^ c.charCodeAt(0), 0).toString(16).toUpperCase().padStart(2, '0')}`;
  const lines = [];
  for (let i = 0; i < 240; i++) {
    const time = `1200${String(Math.floor(i / 10)).padStart(2, '0')}.${i % 10}0`;
    const minutes = (41.55 + i * 0.0002).toFixed(6);
    lines.push(sentence(`GNGGA,${time},52${minutes},N,00909.000000,E,${i < 120 ? 4 : 1},12,0.8,40.0,M,46.9,M,,`));
    lines.push(sentence('GNVTG,0.0,T,,M,7.2,N,13.3,K,A'));
  }
  const file = join(folder, 'receiver.nmea');
  writeFileSync(file, `${lines.join('\n')}\n`);
  return file;
}

flow('the cab says how good positions are, and when they get worse', {}, async ({ page, server }) => {
  const tractor = await startTractor(nmeaLog(server.folder), { per_s: 60 });
  try {
    await openField(page, example('riverside.geojson'));
    await watch(page, tractor, 6);
    const shows = (pattern) => page.waitForFunction((wanted) => new RegExp(wanted).test(document.querySelector('.cab')?.innerText ?? ''), pattern, { timeout: 30_000 });
    await shows('Position\\s*RTK\\s*to about 2 cm');
    await shows('Position\\s*GPS\\s*to some metres');
  } finally {
    await tractor.stop();
  }
});

flow('after a restart of the server the machine is watched again, and the work till then is a drive', { expected: [/ERR_/, /Failed to load/] }, async ({ page, server }) => {
  const tractor = await startTractor(example('riverside-drive.csv'), { per_s: 100, most: 3000 });
  try {
    await openField(page, example('riverside.geojson'));
    await watch(page, tractor);
    await page.waitForTimeout(1500);
    await server.kill();
    await page.getByText('The tramline server does not answer.').first().waitFor({ timeout: 15_000 });
    await server.again();
    await page.getByText('the machine is being watched again').waitFor({ timeout: 30_000 });
    await page.getByLabel('Worked so far').waitFor({ timeout: 30_000 });
    const [drive] = await ask(server, '/drives');
    assert.ok(drive.covered_m2 > 0);
    await page.getByRole('button', { name: 'Leave it running' }).click();
    await page.getByRole('button', { name: new RegExp(drive.name.replace(/[/.]/g, '.')) }).first().waitFor();
  } finally {
    await tractor.stop();
  }
});

flow('a plan for gaps says what the gaps cost and what it costs to work them', {}, async ({ page, server }) => {
  await openField(page, example('riverside.geojson'));
  await goTo(page, 'Review');
  await chooseFile(page, 'Choose the log of a machine', example('riverside-drive.csv'));
  await page.getByRole('button', { name: 'Show what was worked' }).click();
  await page.getByRole('button', { name: 'Plan the gaps' }).click({ timeout: 60_000 });
  await page.getByRole('heading', { name: 'What the repair costs' }).waitFor({ timeout: 180_000 });
  const [plan] = (await ask(server, '/plans')).filter(({ kind }) => kind === 'repair');
  const { repair } = (await ask(server, `/plans/${plan.id}`)).explain;
  assert.ok(repair.cost_if_left > 0 && repair.missed_after_m2 < repair.missed_before_m2);
  const told = await page.getByRole('region', { name: 'What the repair costs' }).innerText();
  assert.ok(told.includes(`€${repair.cost_if_left.toLocaleString('en-GB', { minimumFractionDigits: 2, maximumFractionDigits: 2 })}`), told);
});
