// A hand on the plan: each step is planned at once, priced against the plan before, and can be undone.
import assert from 'node:assert/strict';
import { flow, long } from '../support/flow.mjs';
import { clickMap, goTo, makePlan, newPlan, openField, planTracks, still } from '../support/page.mjs';
import { example } from '../support/server.mjs';
import { ask, openId, smallField } from '../support/stored.mjs';

const hand = (page) => page.getByRole('region', { name: 'By hand' });
const bar = (page) => page.locator('.drawing-bar');
const plan = async (page, server) => ask(server, `/plans/${openId(page, 'plan')}`);
const hash = (page) => new URL(page.url()).hash;

async function drawn(page, button, done, places) {
  const before = hash(page);
  await still(page);
  await hand(page).getByRole('button', { name: button }).click();
  for (const place of places) await clickMap(page, place);
  await bar(page).getByRole('button', { name: done }).click();
  await newPlan(page, before);
}

// Corners of the slant field (support/stored.mjs) are about 9 to 9.0021° E, 50 to 50.0011° N.
const MIDDLE = [[9.0008, 50.0003], [9.0012, 50.0003], [9.0012, 50.0006], [9.0008, 50.0006]];
const WEST = [[8.9999, 49.9999], [9.001, 49.9999], [9.001, 50.0013], [8.9999, 50.0013]];

flow('forbid an area, cut the field, undo and redo', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await planTracks(page);
  await makePlan(page);
  const best = (await plan(page, server)).summary;

  await drawn(page, 'Forbid an area', 'Forbid this area', MIDDLE);
  const forbidden = await plan(page, server);
  assert.equal(forbidden.asked.settings.land[0].kind, 'skip');
  assert.ok(forbidden.summary.given_up_m2 > 700, `${forbidden.summary.given_up_m2} m² are given up`);
  // 0.0004° by 0.0003° of longitude and latitude there: 28.7 m by 33.4 m.
  assert.ok(Math.abs(forbidden.summary.given_up_m2 - 957) < 20, `${forbidden.summary.given_up_m2} m²`);
  await hand(page).getByText(/more than the best plan/).waitFor();
  const more = /€([\d.,]+) more than the best plan/.exec(await hand(page).innerText());
  assert.ok(more, await hand(page).innerText());
  // At the prices of the form: 0.02 for overlap, 0.10 for land left out, 1 a turn, 5 a stop.
  const cost = ({ overlap_m2, uncovered_m2, turns, stops }) => 0.02 * overlap_m2 + 0.1 * uncovered_m2 + turns + 5 * stops;
  assert.ok(Math.abs(Number(more[1]) - (cost(forbidden.summary) - cost(best))) < 0.011, `${more[1]} €`);

  await drawn(page, 'Cut the field', 'Cut here', [[9.0010, 49.9999], [9.0010, 50.0013]]);
  assert.equal((await plan(page, server)).asked.settings.land.length, 2);

  let before = hash(page);
  await hand(page).getByRole('button', { name: 'Undo the last step by hand' }).click();
  await newPlan(page, before);
  assert.deepEqual((await plan(page, server)).summary.given_up_m2, forbidden.summary.given_up_m2);
  before = hash(page);
  await hand(page).getByRole('button', { name: 'Undo the last step by hand' }).click();
  await newPlan(page, before);
  const back = (await plan(page, server)).summary;
  assert.equal(back.cost, best.cost, 'the plan that was there before');
  assert.doesNotMatch(await hand(page).innerText(), /best plan/, 'nobody has a hand in it');
  before = hash(page);
  await hand(page).getByRole('button', { name: 'Redo the step by hand' }).click();
  await newPlan(page, before);
  assert.equal((await plan(page, server)).asked.settings.land.length, 1);
  // After a reload the form still knows what was drawn.
  await page.reload();
  await hand(page).getByRole('button', { name: /^Remove: Forbidden/ }).waitFor();
});

flow('a part keeps its tracks, an area need not be worked', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await planTracks(page);
  await makePlan(page);
  const before = await plan(page, server);
  await page.getByRole('button', { name: 'Zoom out' }).click(); // so that no button lies over a corner
  await drawn(page, 'Keep a part as it is', 'Keep this part', WEST);
  const kept = await plan(page, server);
  const [land] = kept.asked.settings.land;
  assert.equal(land.kind, 'subfield');
  assert.equal(land.guide.length, 2);
  assert.ok(kept.summary.subfields >= 1);
  // A track of the part lies where one lay before: the middle of each is within 5 cm of the line of an old one.
  const lines = async (id) => (await ask(server, `/plans/${id}/layers/tracks`)).features.map(({ geometry }) => (geometry.type === 'LineString' ? geometry.coordinates : geometry.coordinates[0]));
  const [old, now] = [await lines(before.id), await lines(kept.id)];
  const away = ([x, y], [[ax, ay], ...rest]) => {
    const [bx, by] = rest[rest.length - 1];
    const [kx, ky] = [71_700, 111_230];
    const [dx, dy] = [(bx - ax) * kx, (by - ay) * ky];
    return Math.abs((x - ax) * kx * dy - (y - ay) * ky * dx) / Math.hypot(dx, dy);
  };
  const west = now.map((line) => [(line[0][0] + line[line.length - 1][0]) / 2, (line[0][1] + line[line.length - 1][1]) / 2]).filter(([lon]) => lon < 9.0008);
  assert.ok(west.length > 0);
  for (const middle of west) assert.ok(Math.min(...old.map((line) => away(middle, line))) < 0.05, `${middle}`);

  await drawn(page, 'Exempt an area', 'Exempt this area', MIDDLE);
  const exempt = await plan(page, server);
  assert.equal(exempt.asked.settings.land[1].kind, 'done');
  assert.ok(exempt.summary.uncovered_m2 < kept.summary.uncovered_m2 + 50, 'what need not be worked is not missed');
});

/** Drags an end of the line of the direction by so many pixels. */
async function dragEnd(page, [right, down]) {
  await hand(page).getByRole('button', { name: 'Drag the direction' }).click();
  await page.waitForFunction(() => window.tramlineMap.querySourceFeatures('drawing').length > 0);
  const [x, y] = await page.evaluate(() => {
    const map = window.tramlineMap;
    const box = map.getCanvas().getBoundingClientRect();
    const end = map.querySourceFeatures('drawing').filter(({ geometry }) => geometry.type === 'Point').map(({ geometry }) => map.project(geometry.coordinates))[0];
    return [box.left + end.x, box.top + end.y];
  });
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + right, y + down, { steps: 4 });
  await page.mouse.up();
}

flow('the direction is dragged on the map', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await planTracks(page);
  await makePlan(page);
  await still(page);
  const before = hash(page);
  const first = openId(page, 'plan');
  await dragEnd(page, [30, 90]);
  await newPlan(page, before);
  const turned = await plan(page, server);
  assert.equal(turned.summary.direction_deg.length, 1);
  const [[ax, ay], [bx, by]] = turned.asked.settings.line;
  const bearing = (Math.atan2((bx - ax) * Math.cos((50 * Math.PI) / 180), by - ay) * 180) / Math.PI;
  const apart = Math.abs(((((turned.summary.direction_deg[0] - bearing) % 180) + 270) % 180) - 90);
  assert.ok(apart < 0.5, `${turned.summary.direction_deg[0]}° and ${bearing}°`);
  await bar(page).getByRole('button', { name: 'Keep this direction' }).click();
  assert.equal(openId(page, 'plan'), turned.id, 'what was dragged is planned already');

  // Another drag that is given up leaves the direction of the first one.
  let last = hash(page);
  await dragEnd(page, [-40, 20]);
  await newPlan(page, last);
  last = hash(page);
  assert.notDeepEqual((await plan(page, server)).asked.settings.line, turned.asked.settings.line);
  await bar(page).getByRole('button', { name: 'Cancel' }).click();
  await newPlan(page, last);
  const again = await plan(page, server);
  assert.deepEqual(again.asked.settings.line, turned.asked.settings.line);
  assert.deepEqual(again.summary.direction_deg, turned.summary.direction_deg);
  // And one more step back is the plan that nobody had a hand in.
  await hand(page).getByRole('button', { name: 'Undo the last step by hand' }).click();
  await page.waitForFunction((id) => location.hash.includes(id), first);
  assert.equal(await hand(page).getByRole('button', { name: 'Undo the last step by hand' }).isDisabled(), true);
});

flow('the whole job by hand', { skip: long }, async ({ page, server }) => {
  await openField(page, smallField(server.folder, 'angle'));
  await goTo(page, 'Plan');
  await makePlan(page);
  const best = openId(page, 'plan');
  await drawn(page, 'Cut the field', 'Cut here', [[9.0011, 49.9999], [9.0011, 50.0033]]);
  const cut = await plan(page, server);
  assert.ok(cut.summary.whole_cost.euros > 0);
  await hand(page).getByText(/than the (best plan|plan before)|as much as/).first().waitFor();
  assert.equal(cut.asked.edit_of, best);
  assert.equal(cut.asked.settings.headlands, 'auto', 'the next plan is asked for as this one was');
  // After a reload edits still begin from that plan, and are held against it.
  await page.reload();
  await hand(page).getByRole('button', { name: /^Remove: Cut/ }).waitFor();
  await drawn(page, 'Forbid an area', 'Forbid this area', [[9.002, 50.0002], [9.0023, 50.0002], [9.0023, 50.0004], [9.002, 50.0004]]);
  const forbidden = await plan(page, server);
  assert.equal(forbidden.asked.edit_of, best);
  await hand(page).getByText(/more than the best plan|less than the plan before/).waitFor();
  // Plan again searches for everything.
  await makePlan(page);
  assert.equal((await plan(page, server)).asked.edit_of, undefined);
});

flow('edits on a field with obstacles are seen at once', { skip: long }, async ({ page, server }) => {
  await openField(page, example('riverside.geojson'));
  await goTo(page, 'Plan');
  await makePlan(page);
  const best = await plan(page, server);
  const [w, s, e, n] = best.bbox;
  const at = (x, y) => [w + (e - w) * x, s + (n - s) * y];
  const box = (x, y, right, up) => [at(x, y), at(right, y), at(right, up), at(x, up)];
  const took = {};
  const timed = async (name, run) => {
    await still(page);
    const old = hash(page);
    const begin = await run();
    await newPlan(page, old);
    const figures_s = (Date.now() - begin) / 1000;
    await page.waitForSelector('.map[aria-busy=false]');
    took[name] = { figures_s, map_s: (Date.now() - begin) / 1000 };
    assert.equal((await plan(page, server)).asked.edit_of, best.id);
  };
  const shape = (button, done, places) => async () => {
    await hand(page).getByRole('button', { name: button }).click();
    for (const place of places) await clickMap(page, place);
    const begin = Date.now();
    await bar(page).getByRole('button', { name: done }).click();
    return begin;
  };
  await timed('drag', async () => {
    await dragEnd(page, [30, 60]);
    return Date.now();
  });
  await bar(page).getByRole('button', { name: 'Keep this direction' }).click();
  await timed('forbid', shape('Forbid an area', 'Forbid this area', box(0.4, 0.4, 0.5, 0.5)));
  await timed('cut', shape('Cut the field', 'Cut here', [at(0.55, -0.02), at(0.55, 1.02)]));
  await timed('keep', shape('Keep a part as it is', 'Keep this part', box(0.55, -0.02, 1.02, 1.02)));
  await timed('undo', async () => {
    const begin = Date.now();
    await hand(page).getByRole('button', { name: 'Undo the last step by hand' }).click();
    return begin;
  });
  console.log(JSON.stringify({ edits_on: 'riverside, 6 m', took }));
});
