// What was worked: replayed, watched, and mended.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { flow, long, realFile } from './support/flow.mjs';
import { chooseFile, drawn, figure, goTo, mapSettled, openField, panel, planShown } from './support/page.mjs';
import { example } from './support/server.mjs';
import { startTractor } from './support/tractor.mjs';

/** Area of all worked tiles that the map holds, m²: shoelace in metres about 52.69° north, 67 611 m and 111 280 m to a degree. */
async function groundOnMap(page) {
  await mapSettled(page);
  return page.evaluate(async () => {
    const { features } = await window.tramlineMap.getSource('work:covered').getData();
    const ring = (places) => Math.abs(places.reduce((sum, [x, y], i) => {
      const [nx, ny] = places[(i + 1) % places.length];
      const [x0, y0] = places[0];
      return sum + ((x - x0) * (ny - y0) - (nx - x0) * (y - y0)) / 2;
    }, 0)) * 67_611 * 111_280;
    const polygon = ([outer, ...holes]) => ring(outer) - holes.reduce((sum, hole) => sum + ring(hole), 0);
    return features.flatMap(({ geometry }) => geometry.coordinates).reduce((sum, one) => sum + polygon(one), 0);
  });
}

async function evaluateLog(page, log) {
  await goTo(page, 'Review');
  await chooseFile(page, 'Choose the log of a machine', log);
  await page.getByRole('button', { name: 'Show what was worked' }).click();
  await page.getByRole('group', { name: 'Replay' }).waitFor({ timeout: 60_000 });
}

flow('replay a log, look at its gaps, plan their repair', {}, async ({ page, server }) => {
  await openField(page, example('riverside.geojson'));
  await evaluateLog(page, example('riverside-drive.csv'));
  // The figures of `tramline evaluate` for the same log (docs/coverage.md).
  const missed = await figure(page, 'Missed');
  assert.ok(missed > 9_000 && missed < 11_000, `${missed} m² missed`);
  assert.ok((await drawn(page, 'drive:covered')) > 0);

  await page.getByLabel('Speed').selectOption('1000');
  await page.getByRole('button', { name: 'Play the drive' }).click();
  await page.waitForFunction(() => window.tramlineMap.getLayoutProperty('work:covered', 'visibility') === 'visible');
  await page.getByLabel('Worked so far').waitFor();
  const covered = () => figure(page, 'Covered');
  await page.getByRole('button', { name: 'Play the drive' }).waitFor({ timeout: 60_000 }); // it has come to its end
  assert.ok((await drawn(page, 'work:covered')) > 0, 'worked ground has grown on the map');
  const [drive] = await (await fetch(`${server.address}/api/v1/drives`)).json();
  const ground = await groundOnMap(page);
  assert.ok(Math.abs(ground / drive.covered_m2 - 1) < 0.002, `${ground} m² on the map, ${drive.covered_m2} m² covered`);
  const all = await covered();
  assert.ok(all > 11 && all < 12, `${all} ha`);

  // Back to an earlier moment: less is covered, and the replay stands still.
  await page.getByLabel('Time').fill('1000');
  await page.waitForFunction(() => /^0:16:4/.test(document.querySelector('.replay output').textContent));
  await page.getByRole('button', { name: 'Result' }).click();

  const gap = page.locator('.gaps .card').first();
  const zoom = await page.evaluate(() => window.tramlineMap.getZoom());
  await gap.click();
  await page.waitForFunction((was) => window.tramlineMap.getZoom() !== was, zoom);
  const sizes = (await page.locator('.gaps .card strong').allInnerTexts()).map((text) => Number(text.replace(/[^\d.]/g, '')));
  assert.deepEqual(sizes, [...sizes].sort((a, b) => b - a), 'the largest come first');

  await page.getByRole('button', { name: 'Plan the gaps' }).click();
  await planShown(page);
  assert.match(await panel(page).innerText(), /plan for what was missed/);
  assert.ok((await drawn(page, 'plan:tracks')) > 0);
});

flow('a log from elsewhere is told of at once, with ways to go on', { skip: long }, async ({ page, server }) => {
  await openField(page, example('riverside.geojson'));
  await openField(page, example('roadside.geojson')); // some 10 km away
  await goTo(page, 'Review');
  await chooseFile(page, 'Choose the log of a machine', example('riverside-drive.csv'));
  // The field that it was driven on is stored: it is chosen, and the page says why.
  await page.getByText(/not driven on roadside, which is open, but .* km away from it\. It was driven on Riverside, which is chosen/).waitFor();
  const field = page.getByLabel('Field', { exact: true });
  assert.equal(await field.locator('option:checked').innerText(), 'Riverside');
  // Against better knowledge: what is wrong, and two ways on.
  await field.selectOption({ label: 'roadside' });
  await page.getByRole('alert').filter({ hasText: 'This log was not driven on roadside' }).waitFor();
  await page.getByRole('button', { name: 'Show what was worked' }).click();
  await page.getByRole('alert').filter({ hasText: 'nowhere near the field roadside' }).waitFor();
  await page.getByRole('button', { name: 'Show it without a field' }).click();
  await page.getByRole('group', { name: 'Replay' }).waitFor({ timeout: 60_000 });
  assert.equal((await (await fetch(`${server.address}/api/v1/drives`)).json())[0].field, null);

  await chooseFile(page, 'Choose the log of a machine', example('riverside-drive.csv'));
  await page.getByLabel('Field', { exact: true }).selectOption({ label: 'roadside' });
  await page.getByRole('button', { name: 'Show it on Riverside' }).click();
  await page.getByText('Gaps, the largest first').waitFor({ timeout: 60_000 });
});

flow('watch a machine over the network, stop it, and see its drive', { skip: long }, async ({ page }) => {
  const tractor = await startTractor(example('riverside-drive.csv'), { per_s: 400, most: 1500 });
  try {
    await openField(page, example('riverside.geojson'));
    await goTo(page, 'Review');
    await page.getByText('Watch a machine at work').click();
    await page.getByLabel('Host and port').fill(`127.0.0.1:${tractor.port}`);
    await page.getByLabel('Field', { exact: true }).selectOption({ label: 'Riverside' });
    await page.getByRole('button', { name: 'Watch it' }).click();
    await page.getByLabel('Worked so far').waitFor({ timeout: 30_000 });
    const first = await figure(page, 'Covered');
    await page.waitForFunction((was) => Number(document.querySelector('.figures .value').textContent.replace(/[^\d.]/g, '')) > was, first, { timeout: 30_000 });
    assert.ok((await drawn(page, 'work:covered')) > 0);
    await tractor.allSent;
    await page.getByRole('button', { name: 'Stop and store the drive' }).click();
    await page.getByRole('group', { name: 'Replay' }).waitFor({ timeout: 30_000 });
    assert.ok((await figure(page, 'Covered')) > 1);
  } finally {
    await tractor.stop();
  }
});

const sprayer = realFile('logs', 'isoxml_jdsprayer_TLG00015.csv');
flow('a real log from another continent, with a field open: it is replayed without', { skip: long || sprayer.skip }, async ({ page }) => {
  await openField(page, example('riverside.geojson'));
  await goTo(page, 'Review');
  await chooseFile(page, 'Choose the log of a machine', sprayer.file);
  await page.getByText(/not driven on Riverside, which is open, but [78],\d\d0 km away from it\. None of your fields lies there/).waitFor();
  await page.getByRole('button', { name: 'Show what was worked' }).click();
  await page.getByRole('group', { name: 'Replay' }).waitFor({ timeout: 30_000 });
  assert.ok(Math.abs((await figure(page, 'Covered')) - 0.81) < 0.02, 'as tramline evaluate says');
  await page.getByLabel('Speed').selectOption('50');
  await page.getByRole('button', { name: 'Play the drive' }).click();
  await page.getByLabel('Worked so far').waitFor();
});

const real = realFile('logs', 'isoxml_sh2020_TLG00001.csv');
flow('a real log: replay it', { skip: long || real.skip }, async ({ page }) => {
  await evaluateLog(page, real.file);
  assert.ok((await figure(page, 'Covered')) > 0);
  await page.getByLabel('Speed').selectOption('1000');
  await page.getByRole('button', { name: 'Play the drive' }).click();
  await page.getByLabel('Worked so far').waitFor();
});

flow('the scale of meshes is set by the user: for a log, and anew for the drive', { skip: long }, async ({ page, server }) => {
  const drives = async () => (await (await fetch(`${server.address}/api/v1/drives`)).json());
  const openedDrive = async () => (await (await fetch(`${server.address}/api/v1/drives/${(await drives())[0].id}`)).json());
  await openField(page, example('riverside.geojson'));
  await goTo(page, 'Review');
  await chooseFile(page, 'Choose the log of a machine', example('riverside-drive.csv'));
  await page.getByText('How the land is worked out').click();
  assert.equal(await page.getByLabel('Side of a mesh').count(), 0, 'only meshes have a side');
  await page.getByRole('radio', { name: 'By meshes' }).check();
  await page.getByLabel('Side of a mesh').fill('0.25');
  await page.getByLabel('Counts as repeated').selectOption('strict');
  await page.getByLabel('Antenna in front').fill('1.5');
  await page.getByRole('button', { name: 'Show what was worked' }).click();
  await page.getByRole('group', { name: 'Replay' }).waitFor({ timeout: 60_000 });
  const first = await openedDrive();
  assert.equal(first.options.engine, 'mesh');
  assert.equal(first.options.mesh_m, 0.25);
  assert.equal(first.options.repeat, 'strict');
  assert.equal(first.options.antenna_forward_m, 1.5);
  assert.equal(await figure(page, 'Meshes of 0.25 m, covered'), first.summary.meshes.covered.now);
  assert.equal(await figure(page, 'Meshes of 0.25 m, missed'), first.summary.meshes.missed.now);
  assert.ok((await drawn(page, 'drive:covered')) > 0);

  // The replay grows by meshes, too.
  await page.getByLabel('Speed').selectOption('1000');
  await page.getByRole('button', { name: 'Play the drive' }).click();
  await page.getByLabel('Worked so far').waitFor();
  await page.getByRole('button', { name: 'Play the drive' }).waitFor({ timeout: 60_000 }); // it has come to its end
  const ground = await groundOnMap(page);
  assert.ok(Math.abs(ground / first.covered_m2 - 1) < 0.01, `${ground} m² on the map, ${first.covered_m2} m² covered`);
  await page.getByRole('button', { name: 'Result' }).click();

  // Half as long a side: twice as many meshes, about.
  const drive = page.getByRole('region', { name: 'riverside-drive' });
  await drive.getByText('How the land is worked out').click();
  assert.equal(await drive.getByLabel('Side of a mesh').inputValue(), '0.25');
  await drive.getByLabel('Side of a mesh').fill('0.125');
  await drive.getByRole('button', { name: 'Work it out again' }).click();
  await page.locator('dt', { hasText: /^Meshes of 0.125 m, covered$/ }).waitFor({ timeout: 60_000 });
  const finer = await figure(page, 'Meshes of 0.125 m, covered');
  assert.ok(finer > 1.7 * first.summary.meshes.covered.now && finer < 2.3 * first.summary.meshes.covered.now, `${finer} meshes`);
  assert.equal((await openedDrive()).options.antenna_forward_m, 1.5);
  assert.equal((await drives()).length, 1, 'it is the same drive');
});

/** To the east and back to the west, 2 m a second; headings are angles anticlockwise from east: 0 and 180. */
async function logWithAngles() {
  const lines = Array.from({ length: 200 }, (_, i) => {
    const back = i >= 100;
    const [x, y] = [2 * (back ? 200 - i : i), back ? 6 : 0];
    const clock = `08:0${Math.floor(i / 60)}:${String(i % 60).padStart(2, '0')}`;
    return `2026-05-06T${clock}Z,${(9.15 + x / 67_611).toFixed(9)},${(52.69 + y / 111_280).toFixed(9)},6,${back ? 180 : 0}`;
  });
  const file = join(await mkdtemp(join(tmpdir(), 'tramline-angles-')), 'angles.csv');
  await writeFile(file, ['time,lon,lat,width_m,heading', ...lines, ''].join('\n'));
  return file;
}

flow('headings that contradict the way driven are told of, and read otherwise by one press', { skip: long }, async ({ page }) => {
  const file = await logWithAngles();
  await goTo(page, 'Review');
  await chooseFile(page, 'Choose the log of a machine', file);
  await page.getByRole('button', { name: 'Show what was worked' }).click();
  const alert = page.getByRole('alert').filter({ hasText: 'The headings in the log contradict the way driven' });
  await alert.waitFor({ timeout: 60_000 });
  const before = await figure(page, 'Covered');
  await alert.getByRole('button', { name: 'Read them anticlockwise from east' }).click();
  await alert.waitFor({ state: 'detached', timeout: 60_000 });
  await page.getByRole('group', { name: 'Replay' }).waitFor({ timeout: 60_000 }); // the drive is back
  assert.equal(await alert.count(), 0);
  const after = await figure(page, 'Covered');
  assert.equal(before, 0, 'quads along the way have no land');
  assert.equal(after, 0.24, '200 m to and fro, 6 m wide');
  const drive = page.getByRole('region', { name: 'angles' });
  await drive.getByText('How the land is worked out').click();
  assert.equal(await drive.getByLabel('Headings in the log').inputValue(), 'math');
});

flow('watch a machine by meshes', { skip: long }, async ({ page, server }) => {
  const tractor = await startTractor(example('riverside-drive.csv'), { per_s: 400, most: 800 });
  try {
    await goTo(page, 'Review');
    await page.getByText('Watch a machine at work').click();
    await page.getByLabel('Host and port').fill(`127.0.0.1:${tractor.port}`);
    await page.getByText('How the land is worked out').click();
    await page.getByRole('radio', { name: 'By meshes' }).check();
    await page.getByRole('button', { name: 'Watch it' }).click();
    await page.getByLabel('Worked so far').waitFor({ timeout: 30_000 });
    await tractor.allSent;
    const [feed] = await (await fetch(`${server.address}/api/v1/feeds`)).json();
    const { options } = await (await fetch(`${server.address}/api/v1/feeds/${feed.id}`)).json();
    assert.equal(options.engine, 'mesh');
    await page.waitForFunction(() => [...document.querySelectorAll('.figures > div')].some((one) =>
      /^Meshes of 0.05 m, covered/.test(one.textContent) && Number(one.querySelector('.value').textContent.replace(/[^\d]/g, '')) > 1000), null, { timeout: 30_000 });
    assert.ok((await drawn(page, 'work:covered')) > 0);
    await page.getByRole('button', { name: 'Stop and store the drive' }).click();
    await page.getByRole('group', { name: 'Replay' }).waitFor({ timeout: 30_000 });
    assert.ok((await figure(page, 'Meshes of 0.05 m, covered')) > 1000);
  } finally {
    await tractor.stop();
  }
});
