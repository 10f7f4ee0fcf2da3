// What a user does on the page, by the names they see.
import assert from 'node:assert/strict';

export const mapReady = (page) => page.waitForSelector('[data-testid=map][data-ready=true]', { timeout: 60_000 });
export const goTo = (page, view) => page.getByRole('navigation').getByRole('button', { name: view }).click();
/** Opens Plan for tracks alone, which are planned in no time; the whole job takes seconds. */
export async function planTracks(page) {
  await goTo(page, 'Plan');
  await choose(page, 'Tracks, by prices');
}
/** Chooses one of a few things side by side. */
export const choose = (page, name) => page.getByRole('radio', { name }).evaluate((radio) => radio.click());
export const panel = (page) => page.locator('main.panel');

export async function chooseFile(page, label, file) {
  await page.getByLabel(label).setInputFiles(file);
}

export async function openField(page, file, words = { file: 'Choose a file with a field', open: /^Open field/ }) {
  await chooseFile(page, words.file, file);
  await page.getByRole('region', { name: words.open }).waitFor();
}

/** 1,234 m² → 1234; figures of the panel by their label. */
export async function figure(page, label) {
  const text = await page.locator('.figures > div', { has: page.locator('dt', { hasText: new RegExp(`^${label}$`) }) }).locator('.value').first().innerText();
  const number = Number(text.replace(/[^\d.−-]/g, '').replace('−', '-'));
  assert.ok(Number.isFinite(number), `${label}: ${text}`);
  return number;
}

/** Presses the button and waits for the plan that comes of it. */
export async function makePlan(page) {
  const before = new URL(page.url()).hash;
  await page.getByRole('button', { name: /^(Make the plan|Plan again)$/ }).click();
  await newPlan(page, before);
}
export const planShown = (page) => page.waitForSelector('[aria-label="The plan in numbers"]');
export async function newPlan(page, hashBefore) {
  const old = new URLSearchParams(hashBefore.slice(1)).get('plan');
  await page.waitForFunction((was) => {
    const now = new URLSearchParams(location.hash.slice(1)).get('plan');
    return now !== null && now !== was;
  }, old);
  await planShown(page);
}

/** Waits until the map stands still and shows all it was given. */
export const mapSettled = (page) =>
  page.evaluate(async () => {
    const map = window.tramlineMap;
    if (!map.loaded() || map.isMoving()) await new Promise((resolve) => { map.once('idle', () => resolve()); map.triggerRepaint(); });
  });

/** Features of a layer of the map that are drawn right now. */
export async function drawn(page, layer) {
  await page.waitForSelector('.map[aria-busy=false]');
  await mapSettled(page);
  return page.evaluate((name) => window.tramlineMap.queryRenderedFeatures({ layers: [name] }).length, layer);
}

/** Whether a layer is switched on, once all layers of the plan have come. */
export async function visible(page, layer) {
  await page.waitForSelector('.map[aria-busy=false]');
  return page.evaluate((name) => window.tramlineMap.getLayoutProperty(name, 'visibility') !== 'none', layer);
}

/** The picture stands still: nothing is loading or moving. The map begins after the page's first paint. */
export async function still(page) {
  await page.waitForFunction(() => window.tramlineMap);
  await page.evaluate(() => new Promise((resolve) => {
    const map = window.tramlineMap;
    map.once('idle', () => resolve()); // not with the event: all of the map would be sent back, which takes seconds
    map.triggerRepaint();
  }));
}

export async function clickMap(page, place) {
  const [x, y] = await page.evaluate((at) => {
    const map = window.tramlineMap;
    const point = map.project(at);
    const box = map.getCanvas().getBoundingClientRect();
    return [box.left + point.x, box.top + point.y];
  }, place);
  await page.mouse.click(x, y);
}
