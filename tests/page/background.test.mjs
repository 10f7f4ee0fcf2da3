// A picture of the land from this computer below the map, without any network.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after } from 'node:test';
import { flow } from './support/flow.mjs';
import { openField, still } from './support/page.mjs';
import { example } from './support/server.mjs';

// One colour over the riverside field and far round it, in UTM 32.
const COLOUR = [200, 60, 160];
const folder = mkdtempSync(join(tmpdir(), 'tramline-background-'));
after(() => rmSync(folder, { recursive: true, force: true }));
const tif = join(folder, 'land.tif');
const burn = COLOUR.flatMap((value) => ['-burn', String(value)]);
execFileSync('gdal_create', ['-q', '-of', 'GTiff', '-outsize', '800', '800', '-bands', '3', ...burn, '-ot', 'Byte', '-a_srs', 'EPSG:25832', '-a_ullr', '508000', '5841000', '512000', '5837000', tif]);
for (const [driver, name] of [['MBTILES', 'land.mbtiles'], ['GPKG', 'land.gpkg']]) execFileSync('gdal_translate', ['-q', '-of', driver, tif, join(folder, name)]);

/** The colour of the map at a pixel of the screen. */
async function colourAt(page, x, y) {
  const png = (await page.screenshot({ clip: { x, y, width: 1, height: 1 } })).toString('base64');
  return page.evaluate(async (data) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const canvas = new OffscreenCanvas(1, 1).getContext('2d');
    canvas.drawImage(image, 0, 0);
    return [...canvas.getImageData(0, 0, 1, 1).data].slice(0, 3);
  }, png);
}

for (const file of ['land.tif', 'land.mbtiles', 'land.gpkg']) {
  flow(`${file} below the map`, { args: ['--background', join(folder, file)] }, async ({ page }) => {
    await openField(page, example('riverside.geojson'));
    await still(page);
    const box = await page.locator('.maplibregl-canvas').boundingBox();
    // Beside the field, between two lines of the grid.
    const [x, y] = [Math.round(box.x + 97), Math.round(box.y + box.height - 117)];
    const near = (colour) => colour.every((value, i) => Math.abs(value - COLOUR[i]) <= 8);
    assert.ok(!near(await colourAt(page, x, y)), 'off until it is switched on');
    await page.getByRole('button', { name: 'Background' }).click();
    await still(page);
    await page.waitForFunction(() => window.tramlineMap.isSourceLoaded('tiles'));
    await still(page);
    assert.ok(near(await colourAt(page, x, y)), `${await colourAt(page, x, y)}`);
    assert.equal(await page.locator('.attribution').innerText(), file);
  });
}
