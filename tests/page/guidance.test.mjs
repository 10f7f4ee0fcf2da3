// On which side of a line a machine is: values by hand.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const web = new URL('../../web/', import.meta.url);
const { build } = createRequire(new URL('package.json', web))('esbuild');

async function load(path) {
  const { outputFiles } = await build({ entryPoints: [fileURLToPath(new URL(path, web))], bundle: true, format: 'esm', write: false });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);
}

test('right of a line is above 0, whichever way it is driven', async () => {
  const { offLine } = await load('src/map/guidance.ts');
  const line = (order, ...coordinates) => ({ type: 'FeatureCollection', features: [{ type: 'Feature', properties: { order }, geometry: { type: 'LineString', coordinates } }] });
  const north = line(7, [9, 50], [9, 50.01]);
  // A metre of longitude at 50° north: 1/(111,320 cos 50°) of a degree.
  const metre = 1 / (111_320 * Math.cos((50 * Math.PI) / 180));
  const east = [9 + metre, 50.005];
  const near = (found, right_m) => assert.ok(Math.abs(found.right_m - right_m) < 0.01, JSON.stringify(found));
  near(offLine([north], east, 0, 5), 1);
  near(offLine([north], east, 180, 5), -1);
  assert.equal(offLine([north], east, 0, 5).order, 7);
  assert.equal(offLine([north], east, 90, 5), null, 'a line across the way is not followed');
  assert.equal(offLine([north], [9 + 6 * metre, 50.005], 0, 5), null, 'too far');
});
