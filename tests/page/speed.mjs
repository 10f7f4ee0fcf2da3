// How fast the page is: first paint on loopback, steps of a hand on the plan, and frames a second while a map with 5,000 swaths is moved,
// drawn in software. Prints one line of JSON. The first paint is that of a browser which has just been started, beside that of one line of
// text in such a browser, whose own start it is; and of one that has shown a page before.
import { createServer } from 'node:http';
import { closePage, openPage, startBrowser } from './support/browser.mjs';
import { goTo, makePlan, mapReady, openField, planTracks, still } from './support/page.mjs';
import { example, startServer } from './support/server.mjs';
import { openId } from './support/stored.mjs';

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
const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** The first paint of one line of text in a browser that has just been started. */
async function textAlone() {
  const server = createServer((_, answer) => {
    answer.setHeader('content-type', 'text/html');
    answer.end('<!doctype html><title>text</title><p>tramline');
  });
  await new Promise((listens) => server.listen(0, '127.0.0.1', listens));
  const browser = await startBrowser();
  try {
    const page = await browser.newPage();
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    await page.waitForFunction(() => performance.getEntriesByName('first-contentful-paint').length > 0);
    return await firstPaint(page);
  } finally {
    await browser.close();
    server.close();
  }
}

/** From a key that turns the tracks by a degree to the figures of the next plan, ms. */
async function edit(page) {
  const old = openId(page, 'plan');
  await page.getByRole('region', { name: 'By hand' }).getByLabel('Direction', { exact: true }).focus();
  await page.evaluate(() => addEventListener('keydown', () => { window.pressed = performance.now(); }, { once: true, capture: true }));
  await page.keyboard.press('ArrowUp');
  const ms = await page.evaluate((before) => new Promise((resolve) => {
    const look = () => {
      const now = new URLSearchParams(location.hash.slice(1)).get('plan');
      if (now && now !== before && document.querySelector('[aria-label="The plan in numbers"]')) resolve(performance.now() - window.pressed);
      else requestAnimationFrame(look);
    };
    look();
  }), old);
  await still(page);
  return ms;
}

/** On the whole plan of the example field. */
async function editTimes(browser, server) {
  const page = await openPage(browser, server.address, {});
  await mapReady(page);
  await openField(page, example('riverside.geojson'));
  await goTo(page, 'Plan');
  await makePlan(page);
  await still(page);
  const out = [];
  for (let i = 0; i < 7; i++) out.push(await edit(page));
  await closePage(page);
  return out;
}

const text_alone_ms = await textAlone();
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
  const edits = await editTimes(browser, server);
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
  console.log(JSON.stringify({
    first_paint_ms: Math.round(first_paint_ms), text_alone_ms: Math.round(text_alone_ms), first_paint_later_ms: Math.round(median(later)),
    map_ready_ms: Math.round(map_ms), edit_ms: Math.round(median(edits)), swaths: SWATHS, frames_per_s: rates,
  }));
  await closePage(page);
} finally {
  await browser.close();
  await server.stop();
}
