// A picture of the land below, when it is asked for, and never otherwise.
import assert from 'node:assert/strict';
import { after } from 'node:test';
import { join } from 'node:path';
import { flow } from './support/flow.mjs';
import { goTo, makePlan, openField, panel, planTracks, still } from './support/page.mjs';
import { example } from './support/server.mjs';
import { startTiles } from './support/tiles.mjs';

const tiles = await startTiles();
after(() => tiles.stop());

async function shot(page, name) {
  await still(page);
  if (process.env.TRAMLINE_SHOTS) await page.screenshot({ path: join(process.env.TRAMLINE_SHOTS, `${name}.png`) });
}
const loadedTiles = (page) => page.evaluate(() => window.tramlineMap.isSourceLoaded('tiles'));

flow('a background is asked for when it is switched on', { args: ['--tiles', tiles.url, '--tiles-attribution', '© Makers of tiles'], allowed: [tiles.origin] }, async ({ page }) => {
  await openField(page, example('riverside.geojson'));
  await still(page);
  assert.equal(tiles.asked(), 0, 'nothing is asked for before');
  assert.equal(await page.getByText('© Makers of tiles').count(), 0);
  await page.getByRole('button', { name: 'Background' }).click();
  await page.getByText('© Makers of tiles').waitFor();
  await still(page); // no tile is asked for before the next picture
  await page.waitForFunction(() => window.tramlineMap.isSourceLoaded('tiles'));
  assert.ok(tiles.asked() > 0);
  assert.ok(await loadedTiles(page));
  await shot(page, 'tiles-field');
  await planTracks(page);
  await makePlan(page);
  await shot(page, 'tiles-plan');
  await page.getByRole('button', { name: 'Change to the night theme' }).click();
  await shot(page, 'tiles-night');
  assert.equal(await page.evaluate(() => window.tramlineMap.getLayoutProperty('tiles', 'visibility')), 'visible', 'it stays on at night');
  await page.getByRole('button', { name: 'Background' }).click();
  assert.equal(await page.getByText('© Makers of tiles').count(), 0);
  assert.equal(await page.evaluate(() => window.tramlineMap.getPaintProperty('field-ground', 'fill-opacity')), 1);
});

flow('a background that does not come is told of once, and all else works', { args: ['--tiles', tiles.url], allowed: [tiles.origin], expected: [/status of 500/] }, async ({ page }) => {
  tiles.fail(true);
  try {
    await openField(page, example('riverside.geojson'));
    await page.getByRole('button', { name: 'Background' }).click();
    const notice = page.getByRole('alert').filter({ hasText: 'The background could not be loaded from 127.0.0.1' });
    await notice.waitFor();
    assert.equal(await notice.count(), 1);
    assert.match(await page.locator('.attribution').innerText(), /^Background: 127\.0\.0\.1:\d+$/);
    await planTracks(page);
    await makePlan(page);
    // With tiles that fail the map may never call itself idle; what it draws is what counts.
    await page.waitForFunction(() => window.tramlineMap.queryRenderedFeatures({ layers: ['plan:tracks'] }).length > 10);
    assert.equal(await notice.count(), 1);
  } finally {
    tiles.fail(false);
  }
});

flow('the policy lets in that host and no other', { args: ['--tiles', tiles.url], allowed: [tiles.origin, 'http://127.0.0.2'], expected: [/Content Security Policy/, /violates the following/, /Refused to/] }, async ({ page, server }) => {
  const policy = (await fetch(server.address)).headers.get('content-security-policy');
  assert.match(policy, new RegExp(`img-src 'self' data: blob: ${tiles.origin}`));
  const reached = (address) => page.evaluate((url) => fetch(url).then(() => true, () => false), address);
  assert.equal(await reached(`${tiles.origin}/1/0/0.png`), true);
  assert.equal(await reached('http://127.0.0.2:9/1/0/0.png'), false);
});

flow('without --tiles nothing is asked for elsewhere, and no button offers it', {}, async ({ page, server }) => {
  // openPage() fails every flow whose page asks for anything elsewhere.
  const policy = (await fetch(server.address)).headers.get('content-security-policy');
  assert.doesNotMatch(policy, /https?:/);
  assert.equal(await page.getByRole('button', { name: 'Background' }).count(), 0);
  await openField(page, example('riverside.geojson'));
  await still(page);
  assert.match(await panel(page).innerText(), /12\.13 ha/);
});
