// How fast the page is: first paint on loopback, and frames a second while a map with 5,000 swaths is moved,
// drawn in software. Prints one line of JSON.
import { closePage, openPage, startBrowser } from './support/browser.mjs';
import { goTo, makePlan, mapReady, openField, still } from './support/page.mjs';
import { example, startServer } from './support/server.mjs';

const SWATHS = 5000;
const SECONDS = 6;

/** Two hundred metres of lines and strips a metre apart, over the field that is open. */
function manySwaths(box) {
  const [w, s, e, n] = box;
  const swaths = [];
  const tracks = [];
  for (let i = 0; i < SWATHS; i++) {
    const [low, high] = [s + ((n - s) * i) / SWATHS, s + ((n - s) * (i + 1)) / SWATHS];
    const order = i + 1;
    swaths.push({ type: 'Feature', properties: { order, area_m2: 1 }, geometry: { type: 'Polygon', coordinates: [[[w, low], [e, low], [e, high], [w, high], [w, low]]] } });
    tracks.push({ type: 'Feature', properties: { order, length_m: 1 }, geometry: { type: 'LineString', coordinates: [[w, (low + high) / 2], [e, (low + high) / 2]] } });
  }
  return { swaths, tracks };
}

const browser = await startBrowser();
const server = await startServer();
try {
  const page = await openPage(browser, server.address, { reducedMotion: 'no-preference' });
  await mapReady(page);
  const first_paint_ms = await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime);
  const map_ms = await page.evaluate(() => performance.now());
  await openField(page, example('riverside.geojson'));
  await goTo(page, 'Plan');
  const box = await page.evaluate(() => { const b = window.tramlineMap.getBounds(); return [b.getWest(), b.getSouth(), b.getEast(), b.getNorth()]; });
  const { swaths, tracks } = manySwaths(box);
  for (const [name, features] of [['swaths', swaths], ['tracks', tracks]]) {
    await page.route(`**/layers/${name}`, (route) => route.fulfill({ json: { type: 'FeatureCollection', features } }));
  }
  await makePlan(page);
  await page.locator('.legend .switch', { hasText: /^Swaths/ }).getByRole('switch').check({ force: true });
  await page.waitForFunction(() => window.tramlineMap.getLayoutProperty('plan:swaths', 'visibility') === 'visible');
  await still(page);

  const moved = await page.evaluate((seconds) => new Promise((resolve) => {
    const map = window.tramlineMap;
    const renders = [];
    map.on('render', () => renders.push(performance.now()));
    const begin = performance.now();
    const step = () => {
      const t = (performance.now() - begin) / 1000;
      if (t > seconds) {
        const gaps = renders.slice(1).map((at, i) => at - renders[i]).sort((a, b) => a - b);
        resolve({ frames: renders.length, seconds: t, median_ms: gaps[gaps.length >> 1], worst_ms: gaps[gaps.length - 1] });
        return;
      }
      map.panBy([Math.round(6 * Math.cos(t * 3)), Math.round(6 * Math.sin(t * 3))], { duration: 0 });
      requestAnimationFrame(step);
    };
    step();
  }), SECONDS);
  console.log(JSON.stringify({
    first_paint_ms: Math.round(first_paint_ms), map_ready_ms: Math.round(map_ms), swaths: SWATHS,
    frames_per_s: +(moved.frames / moved.seconds).toFixed(1), median_frame_ms: +moved.median_ms.toFixed(1), worst_frame_ms: Math.round(moved.worst_ms),
  }));
  await closePage(page);
} finally {
  await browser.close();
  await server.stop();
}
