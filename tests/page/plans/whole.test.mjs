// The whole job: what is planned where nobody chooses, in hours, litres and euros.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { flow, realFile } from '../support/flow.mjs';
import { choose, drawn, figure, goTo, makePlan, newPlan, openField, panel, visible } from '../support/page.mjs';
import { example } from '../support/server.mjs';
import { ask, openId, smallField, storeField, storePlan } from '../support/stored.mjs';

const near = (a, b, by) => assert.ok(Math.abs(a - b) <= by, `${a} is not ${b} ± ${by}`);

flow('without a choice the whole job is planned, and its figures are those of the server', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await goTo(page, 'Plan');
  await makePlan(page);
  const { summary, asked, headland_sides } = await ask(server, `/plans/${openId(page, 'plan')}`);
  assert.equal(asked.objective, undefined, 'no prices of tracks were asked for');
  assert.ok(summary.route.legs.length > 0, 'it has a route');
  assert.ok(summary.headland_passes > 0, 'turns have their headland');
  await panel(page).getByText('Headland along each side').click();
  const rows = await panel(page).locator('details[open] tbody tr').allTextContents();
  assert.equal(rows.length, Math.min(6, headland_sides.length));
  headland_sides.slice(0, 6).forEach(({ passes }, i) => assert.ok(rows[i].includes(passes === 0 ? 'none' : `${passes} pass`), rows[i]));
  near(await figure(page, 'Whole cost'), summary.whole_cost.euros, 0.006);
  near(await figure(page, 'Time'), summary.route.time_s / 3600, 0.006);
  near(await figure(page, 'Fuel'), summary.whole_cost.litres, 0.06);
  const parts = ['hours', 'fuel', 'overlap', 'missed', 'stops', 'driven_over'].reduce((sum, part) => sum + summary.whole_cost[`euros_${part}`], 0);
  near(parts, summary.whole_cost.euros, 1e-6);
  assert.equal(await drawn(page, 'plan:route-ends'), 2, 'where it starts and ends');
  assert.ok((await drawn(page, 'plan:route-forward')) > 0, 'ways with the work off');

  // Twice the price per hour, and nothing else: the hours cost twice as much.
  const hash = new URL(page.url()).hash;
  await page.getByLabel('Machine and driver', { exact: true }).fill('180');
  await newPlan(page, hash);
  const dearer = (await ask(server, `/plans/${openId(page, 'plan')}`)).summary.whole_cost;
  assert.equal(dearer.rates.price_per_hour, 180);
  near(dearer.euros_hours, 180 * dearer.hours, 0.01);
  assert.equal(await page.locator('.figures > div', { hasText: 'Whole cost' }).locator('.change').count(), 0, 'money by other rates is not compared');
});

flow('tracks by prices or sliders are planned alone', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await goTo(page, 'Plan');
  await choose(page, 'Tracks, by prices');
  await makePlan(page);
  const { summary, asked } = await ask(server, `/plans/${openId(page, 'plan')}`);
  assert.equal(summary.route, undefined);
  assert.equal(asked.objective.prices.turn, 1);
  near(await figure(page, 'Cost'), summary.cost, 0.006);
});

flow('a field opens with its last plan, and the form is as it was made', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await goTo(page, 'Plan');
  await choose(page, 'Tracks, by prices');
  await makePlan(page);
  await page.getByText('1 plan of this field').waitFor();
  const first = openId(page, 'plan');
  let hash = new URL(page.url()).hash;
  await page.getByLabel('Working width', { exact: true }).fill('12');
  await newPlan(page, hash);
  const edge = page.getByLabel('Parallel to');
  hash = new URL(page.url()).hash;
  await edge.selectOption({ label: await edge.locator('option', { hasText: /^edge 2:/ }).innerText() });
  await newPlan(page, hash);
  await page.getByRole('button', { name: 'Keep it' }).click();
  await page.getByText('A draft:').waitFor({ state: 'detached' });
  const second = openId(page, 'plan');
  const made = (await ask(server, `/plans/${second}`)).asked;

  // The draft of 12 m is still there: the plan along the edge is an edit of it.
  await page.getByText('3 plans of this field').click();
  const rows = page.getByRole('region', { name: 'Plans of this field' }).locator('.card');
  assert.equal(await rows.count(), 3);
  for (const [i, row] of [/12 m wide/, /12 m wide/, /6 m wide/].entries()) assert.match(await rows.nth(i).innerText(), row);
  assert.ok(await rows.nth(0).locator('img').evaluate((img) => img.decode().then(() => img.naturalWidth > 0)), 'each has its picture');
  await rows.nth(2).click();
  await page.waitForFunction((id) => location.hash.includes(`plan=${id}`), first);
  // The form follows once the plan has been read.
  const width = await page.getByLabel('Working width', { exact: true }).elementHandle();
  await page.waitForFunction((input) => input.value === '6', width);
  await page.waitForTimeout(800);
  const kept = await ask(server, `/plans?field=${openId(page, 'field')}`);
  assert.equal(kept.length, 3, 'looking at a plan makes none');
  assert.deepEqual(kept.map(({ draft }) => draft), [false, true, false], 'and keeps none');

  // In another window, with nothing in the address and nothing remembered.
  const other = await page.context().browser().newContext();
  const fresh = await other.newPage();
  await fresh.goto(server.address);
  await fresh.locator('#stored-fields .card').first().click();
  await fresh.waitForFunction((id) => location.hash.includes(`plan=${id}`), second);
  await goTo(fresh, 'Plan');
  assert.equal(await fresh.getByLabel('Working width', { exact: true }).inputValue(), '12');
  // The line that was chosen is still the one that the next plan follows.
  hash = new URL(fresh.url()).hash;
  await fresh.getByLabel('Turning radius', { exact: true }).fill('5');
  await newPlan(fresh, hash);
  assert.deepEqual((await ask(server, `/plans/${openId(fresh, 'plan')}`)).asked.settings.line, made.settings.line);
  await other.close();
});

flow('a plan that is finished after a reload appears by itself', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await goTo(page, 'Plan');
  await page.getByRole('button', { name: 'Make the plan' }).click();
  await page.getByRole('button', { name: 'Cancel' }).waitFor();
  await page.reload();
  await page.waitForFunction(() => new URLSearchParams(location.hash.slice(1)).get('plan') !== null, null, { timeout: 60_000 });
  assert.ok((await figure(page, 'Whole cost')) > 0);
});

flow('a divided plan says what one direction would cost, and takes it by one click', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder, 'angle'));
  await goTo(page, 'Plan');
  await choose(page, 'Tracks, by prices');
  await page.getByLabel('Each further subfield').fill('0');
  await makePlan(page);
  const divided = await ask(server, `/plans/${openId(page, 'plan')}`);
  assert.ok(divided.summary.subfields > 1);
  const aside = page.getByRole('group', { name: 'One direction' });
  const told = Number(/: €([\d.,]+),/.exec(await aside.innerText())[1].replace(',', ''));
  const undivided = divided.explain.runner_ups.find((other) => other.subfields === 1);
  near(told, undivided.cost, 0.006);
  const hash = new URL(page.url()).hash;
  await aside.getByRole('button', { name: 'Take one direction' }).click();
  await newPlan(page, hash);
  const taken = (await ask(server, `/plans/${openId(page, 'plan')}`)).summary;
  assert.equal(taken.subfields, 1);
  near(((taken.direction_deg[0] - undivided.direction_deg[0] + 270) % 180) - 90, 0, 0.3);
});

flow('land worked outside the field is said beside the overlap and drawn', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder, 'angle'));
  await goTo(page, 'Plan');
  await choose(page, 'Tracks, by prices');
  await page.getByLabel('Swaths end at a slanting edge').selectOption('cover');
  await makePlan(page);
  const { summary } = await ask(server, `/plans/${openId(page, 'plan')}`);
  assert.ok(summary.outside_m2 > 1 && summary.outside_m2 <= summary.overlap_m2 + 0.01);
  assert.match(await panel(page).innerText(), new RegExp(`${Math.round(summary.outside_m2).toLocaleString('en-GB')} m² outside`));
  assert.ok((await drawn(page, 'plan:outside')) > 0);
});

flow('the route is driven on the map, and what it takes adds up to the plan', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await goTo(page, 'Plan');
  await makePlan(page);
  const { summary } = await ask(server, `/plans/${openId(page, 'plan')}`);
  const player = page.getByRole('group', { name: 'Drive the route' });
  const time = player.getByLabel('Time');
  const seek = (s) => time.evaluate((input, to) => { input.value = String(to); input.dispatchEvent(new Event('input', { bubbles: true })); }, s);
  await seek(summary.route.time_s);
  near(await figure(page, 'Fuel so far'), summary.whole_cost.litres, 0.06);
  near(await figure(page, 'Machine and fuel'), summary.whole_cost.euros_hours + summary.whole_cost.euros_fuel, 0.01);
  await seek(summary.route.time_s / 2);
  assert.ok((await figure(page, 'Fuel so far')) < summary.whole_cost.litres);
  assert.equal(await drawn(page, 'route-machine'), 1);
  await player.getByLabel('Speed').selectOption('600');
  await player.getByRole('button', { name: 'Drive the route' }).click();
  await page.waitForFunction(() => { const slider = document.querySelector('[aria-label="Drive the route"] input[type=range]'); return Number(slider.max) - Number(slider.value) < 0.01; });
  await player.getByRole('button', { name: 'Drive the route' }).waitFor();
  await player.getByRole('button', { name: 'Whole route' }).click();
  assert.equal(await visible(page, 'route-machine'), false);
});

flow('figures come before layers, and layers are compressed and as fine as the screen', {}, async ({ page, server }) => {
  const field = smallField(server.folder);
  await openField(page, field);
  await goTo(page, 'Plan');
  let release;
  const held = new Promise((resolve) => { release = resolve; });
  const asked = [];
  await page.route(/\/layers\/[^/]+$/, async (route) => {
    asked.push(route.request().url());
    await held;
    await route.continue();
  });
  await makePlan(page);
  assert.ok((await figure(page, 'Whole cost')) > 0, 'figures are there without any layer');
  release();
  assert.ok((await drawn(page, 'plan:tracks')) > 0);
  assert.ok(asked.length > 3 && asked.every((url) => /detail_m=0\.\d+/.test(url)), asked[0]);
  const layer = `${server.address}/api/v1/plans/${openId(page, 'plan')}/layers/route_legs`;
  const sent = async (path, encoding) => (await fetch(path, { headers: { 'Accept-Encoding': encoding } })).headers;
  assert.equal((await sent(layer, 'gzip')).get('content-encoding'), 'gzip');
  assert.equal((await sent(layer, 'identity')).get('content-encoding'), null);
  const read = async (path) => {
    const answer = await fetch(path);
    assert.equal(answer.status, 200);
    return (await answer.json()).features;
  };
  const [fine, coarse] = [await read(layer), await read(`${layer}?detail_m=0.3`)];
  assert.deepEqual(coarse.map((leg) => leg.properties), fine.map((leg) => leg.properties), 'the same legs');
  const numbers = (legs) => legs.flatMap((leg) => leg.geometry.coordinates.flat(Infinity)).length;
  assert.ok(numbers(coarse) > 0 && numbers(coarse) < numbers(fine), 'of fewer vertices');
});

flow('progress never falls, is not all before the plan is there, and says how long it takes still', {}, async ({ page }) => {
  await openField(page, example('riverside.geojson')); // long enough to have time left
  await goTo(page, 'Plan');
  await page.evaluate(() => {
    window.told = [];
    new MutationObserver(() => {
      const bar = document.querySelector('main progress');
      if (bar) window.told.push([bar.value, bar.parentElement.innerText]);
    }).observe(document.querySelector('main'), { subtree: true, childList: true, attributes: true, characterData: true });
  });
  await makePlan(page);
  const told = await page.evaluate(() => window.told);
  const shares = told.map(([share]) => share).filter((share) => share > 0);
  assert.ok(new Set(shares).size >= 3, `steps of the progress: ${[...new Set(shares)].join()}`);
  assert.ok(shares.every((share, i) => i === 0 || share >= shares[i - 1]), shares.join());
  assert.ok(told.some(([, text]) => /left\.|Nearly done\./.test(text)), 'the time left is said');
});

/** Bytes of answers as they went over the line, by path. */
async function bytesOf(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('Network.enable');
  const paths = new Map();
  const sum = { figures: 0, layers: 0 };
  session.on('Network.responseReceived', ({ requestId, response }) => paths.set(requestId, new URL(response.url).pathname));
  session.on('Network.loadingFinished', ({ requestId, encodedDataLength }) => {
    const path = paths.get(requestId) ?? '';
    if (/\/layers\//.test(path)) sum.layers += encodedDataLength;
    else if (/\/plans\//.test(path)) sum.figures += encodedDataLength;
  });
  return { session, sum };
}

const ONE_MBIT = 125_000;
/** Fields with many corners make plans with many points. */
const LARGE = realFile('fields', 'fields.geojson');
for (const [name, skip, feature] of [
  ['riverside', false, () => JSON.parse(readFileSync(example('riverside.geojson'))).features[0]],
  ['bg/9', process.env.TRAMLINE_LONG ? LARGE.skip : 'a large field takes its time: make long-page', () => JSON.parse(readFileSync(LARGE.file)).features.find(({ properties }) => properties.id === 'bg/9')],
]) {
  flow(`a plan of ${name} at 1 Mbit/s`, { skip }, async ({ page, server }) => {
    const field = await storeField(server, feature());
    const plan = await storePlan(server, field, 5);
    const { session, sum } = await bytesOf(page);
    await session.send('Network.emulateNetworkConditions', { offline: false, latency: 40, downloadThroughput: ONE_MBIT, uploadThroughput: ONE_MBIT });
    // The page itself is there already, as after the first visit: what comes is the plan.
    await page.goto('about:blank');
    const begin = Date.now();
    await page.goto(`${server.address}/#view=plan&field=${field}&plan=${plan}`);
    await page.locator('.figures').first().waitFor();
    const figures_s = (Date.now() - begin) / 1000;
    await page.waitForFunction(() => window.tramlineMap?.getSource('plan:tracks'));
    await page.waitForSelector('.map[aria-busy=false]');
    console.log(JSON.stringify({ at: '1 Mbit/s', field: name, bytes: sum, figures_s, map_s: (Date.now() - begin) / 1000 }));
    // What the line can carry in five seconds.
    assert.ok(sum.layers > 1000 && sum.figures + sum.layers < 5 * ONE_MBIT, JSON.stringify(sum));
  });
}
