// How fast the page is: first paint on loopback, and frames a second while a map with 5,000 swaths is moved,
// drawn in software. Prints one line of JSON. The first paint is that of a browser which has just been started, whose own start of drawing is
// part of it, and of one that has shown a page before.
import { closePage, openPage, startBrowser } from './support/browser.mjs';
import { goTo, makePlan, mapReady, openField, planTracks, still } from './support/page.mjs';
import { example, startServer } from './support/server.mjs';

const SWATHS = 5000;
const SECONDS = 6;

/** A field of 360 ha in ten columns: swaths 6 m wide and 120 m long, about the middle of the box. */
function manySwaths([w, s, e, n]) {
  const [lon0, lat0] = [(w + e) / 2, (s + n) / 2];
  const at = (x, y) => [lon0 + x / (111_320 * Math.cos((lat0 * Math.PI) / 180)), lat0 + y / 111_200];
  const swaths = [];
  const tracks = [];
  for (let i = 0; i < SWATHS; i++) {
    const [x, y, order] = [(Math.floor(i / 500) - 5) * 120, ((i % 500) - 250) * 6, i + 1];
    swaths.push({ type: 'Feature', properties: { order, area_m2: 720 }, geometry: { type: 'Polygon', coordinates: [[at(x, y), at(x + 120, y), at(x + 120, y + 6), at(x, y + 6), at(x, y)]] } });
    tracks.push({ type: 'Feature', properties: { order, length_m: 120 }, geometry: { type: 'LineString', coordinates: [at(x, y + 3), at(x + 120, y + 3)] } });
  }
  return { swaths, tracks };
}

/** Moves the map in circles and counts what it draws. */
const framesPerSecond = (page) =>
  page.evaluate((seconds) => new Promise((resolve) => {
    const map = window.tramlineMap;
    let frames = 0;
    const count = () => frames++;
    map.on('render', count);
    const begin = performance.now();
    const step = () => {
      const t = (performance.now() - begin) / 1000;
      if (t > seconds) {
        map.off('render', count);
        resolve(Math.round((10 * frames) / t) / 10);
        return;
      }
      map.panBy([Math.round(6 * Math.cos(t * 3)), Math.round(6 * Math.sin(t * 3))], { duration: 0 });
      requestAnimationFrame(step);
    };
    step();
  }), SECONDS);

const firstPaint = (page) => page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime);

const browser = await startBrowser();
const server = await startServer();
try {
  const page = await openPage(browser, server.address, { reducedMotion: 'no-preference' });
  await mapReady(page);
  const first_paint_ms = await firstPaint(page);
  const map_ms = await page.evaluate(() => performance.now());
  const later = [];
  for (let i = 0; i < 5; i++) {
    const again = await openPage(browser, server.address, {});
    await mapReady(again);
    later.push(await firstPaint(again));
    await closePage(again);
  }
  const first_paint_later_ms = later.sort((a, b) => a - b)[2];
  await openField(page, example('riverside.geojson'));
  await planTracks(page);
  const box = await page.evaluate(() => { const b = window.tramlineMap.getBounds(); return [b.getWest(), b.getSouth(), b.getEast(), b.getNorth()]; });
  const { swaths, tracks } = manySwaths(box);
  for (const [name, features] of [['swaths', swaths], ['tracks', tracks]]) {
    await page.route(`**/layers/${name}`, (route) => route.fulfill({ json: { type: 'FeatureCollection', features } }));
  }
  await makePlan(page);
  await page.locator('.legend .switch', { hasText: /^Swaths/ }).getByRole('switch').check({ force: true });
  await page.waitForFunction(() => window.tramlineMap.getLayoutProperty('plan:swaths', 'visibility') === 'visible');
  await still(page);

  // All of the field in sight, then as near as one works with it.
  const rates = {};
  for (const [name, zoom] of [['whole_field', 13.6], ['near', 16]]) {
    await page.evaluate((to) => window.tramlineMap.jumpTo({ zoom: to }), zoom);
    await still(page);
    rates[name] = await framesPerSecond(page);
  }
  console.log(JSON.stringify({ first_paint_ms: Math.round(first_paint_ms), first_paint_later_ms: Math.round(first_paint_later_ms), map_ready_ms: Math.round(map_ms), swaths: SWATHS, frames_per_s: rates }));
  await closePage(page);
} finally {
  await browser.close();
  await server.stop();
}
