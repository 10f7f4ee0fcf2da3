// A field and an obstacle drawn on the map, with the pointer and by numbers.
import assert from 'node:assert/strict';
import { flow, long } from '../support/flow.mjs';
import { clickMap, drawn, figure, goTo, makePlan, mapReady, openField, panel, planTracks, still } from '../support/page.mjs';
import { ask, polygonOf, smallField, storeField } from '../support/stored.mjs';

/** Where a place is on the screen. */
const onScreen = (page, place) =>
  page.evaluate((at) => {
    const point = window.tramlineMap.project(at);
    const box = window.tramlineMap.getCanvas().getBoundingClientRect();
    return [box.left + point.x, box.top + point.y];
  }, place);

async function drag(page, from, to) {
  await still(page);
  const [a, b] = [await onScreen(page, from), await onScreen(page, to)];
  await page.mouse.move(...a);
  await page.mouse.down();
  await page.mouse.move((a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
  await page.mouse.move(...b);
  await page.mouse.up();
}
const area = async (page) => Number(/; ([\d.,]+) ha/.exec(await page.locator('.drawing-bar').innerText())[1]);

flow('corners are dragged, inserted and deleted, undone and redone; a click on the first one closes, and so does Enter; a field by numbers, with an obstacle, is planned', {}, async ({ page }) => {
  await page.getByRole('button', { name: 'Draw a field' }).click();
  const middle = await page.evaluate(() => window.tramlineMap.getCenter().toArray());
  const at = (x, y) => [middle[0] + x * 0.0011, middle[1] + y * 0.0007];
  const square = [at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)];
  for (const corner of square) await clickMap(page, corner);
  // 154.4 m by 155.8 m, as above.
  assert.ok(Math.abs((await area(page)) - 2.405) < 0.02, String(await area(page)));
  await drag(page, at(1, 1), at(2, 1));
  const dragged = await area(page);
  assert.ok(Math.abs(dragged - 1.25 * 2.405) < 0.03, `a triangle of a quarter more: ${dragged}`);
  await page.getByRole('button', { name: 'Undo' }).click();
  assert.ok(Math.abs((await area(page)) - 2.405) < 0.02);
  await page.getByRole('button', { name: 'Redo' }).click();
  assert.equal(await area(page), dragged);
  await page.getByRole('button', { name: 'Undo' }).click();

  await drag(page, at(0, -1), at(0, -2));
  assert.ok(Math.abs((await area(page)) - 1.25 * 2.405) < 0.03, 'a new corner between two others');
  await page.locator('.drawing-bar', { hasText: '5 points set' }).waitFor();
  await page.getByRole('button', { name: 'Delete the corner' }).click();
  assert.ok(Math.abs((await area(page)) - 2.405) < 0.02);

  await clickMap(page, square[0]);
  await page.getByRole('region', { name: /^Open field/ }).waitFor();
  assert.match(await panel(page).innerText(), /2\.4[01] ha/);

  // Enter closes what was pointed at. The field before is still in sight.
  await page.getByRole('button', { name: 'Draw a field' }).click();
  for (const [x, y] of [[-1, -1], [1, -1], [0, 1]]) await clickMap(page, [middle[0] + x * 0.0011, middle[1] + y * 0.0007]);
  await page.locator('.maplibregl-canvas').focus();
  await page.keyboard.press('Enter');
  await page.getByRole('region', { name: /^Open field/ }).filter({ hasText: /1\.20 ha/ }).waitFor();

  // By numbers: a corner, then metres.
  await page.getByRole('button', { name: 'Draw a field' }).click();
  const type = async (text) => {
    await page.locator('.drawing-bar input').fill(text);
    await page.locator('.drawing-bar input').press('Enter');
  };
  await type('52.69 9.15');
  await type('200 0');
  await type('0 100');
  await type('-200 0');
  await page.getByRole('button', { name: 'Store the field' }).click();
  await page.getByRole('region', { name: /^Open field/ }).filter({ hasText: /2\.00 ha/ }).waitFor();

  // An obstacle in it, and a plan round that.
  await page.getByText('Add an obstacle').click();
  await page.getByLabel('How wide it is').fill('6');
  await page.getByRole('button', { name: 'Place it on the map' }).click();
  await still(page);
  await clickMap(page, [9.15 + 100 / 67_570, 52.69 + 50 / 111_260]); // its middle: metres to a degree at 52.69° north
  await page.getByRole('button', { name: 'Add the obstacle' }).click();
  await page.getByText('1 obstacle').first().waitFor();
  assert.ok((await drawn(page, 'obstacle')) > 0);

  await planTracks(page);
  await makePlan(page);
  const tracks = await figure(page, 'Tracks');
  // 100 m across, 6 m wide: 17 tracks along the field, and one or two more where the obstacle parts them.
  assert.ok(tracks >= 16 && tracks <= 20, `${tracks} tracks`);
});

flow('a boundary is changed later, and an obstacle: corners dragged, inserted, deleted; plans of the earlier shape are marked', { skip: long }, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await page.getByText('Add an obstacle').click();
  await page.getByRole('button', { name: 'Place it on the map' }).click();
  await clickMap(page, [9.001, 50.0005]);
  await page.getByRole('button', { name: 'Add the obstacle' }).click();
  await page.getByText('1 obstacle').first().waitFor();
  await planTracks(page);
  await makePlan(page);
  await goTo(page, 'Fields');
  await page.getByRole('button', { name: 'Change the boundary' }).click();
  const [before] = await ask(server, '/fields');
  await drag(page, [9.0021, 50], [9.0026, 50]);
  await page.getByRole('button', { name: 'Keep this boundary' }).click();
  await page.locator('.drawing-bar').waitFor({ state: 'detached' });
  const [after] = await ask(server, '/fields');
  // The triangle over the south-eastern corner: 0.0005° of longitude by half of 0.0009° of latitude.
  const more = (0.0005 * 111_320 * Math.cos((50 * Math.PI) / 180) * 0.0009 * 111_240) / 2;
  assert.ok(Math.abs(after.area_m2 - before.area_m2 - more) < 0.01 * more, `${after.area_m2 - before.area_m2} is not ${more}`);
  assert.equal(after.obstacles, 1, 'the obstacle stays');
  await goTo(page, 'Plan');
  await page.getByText('of an earlier shape of the field').first().waitFor();
  await page.locator('.cards .card').first().click();
  await page.getByText('Plan again before you drive.').waitFor();

  // The corner goes back to where it was: the plan is of this shape again.
  await goTo(page, 'Fields');
  await page.getByRole('button', { name: 'Change the boundary' }).click();
  await page.locator('.drawing-bar').waitFor();
  const shape = polygonOf('slant');
  const [{ id }] = await ask(server, '/fields');
  await page.locator('.drawing-bar').getByRole('button', { name: 'Cancel' }).click();
  await fetch(`${server.address}/api/v1/fields/${id}`, { method: 'PATCH', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ boundary: shape }) });
  const [plan] = await ask(server, `/plans?field=${id}`);
  assert.equal(plan.earlier_shape, false);
  await changeAnObstacle(page, server);
});

async function changeAnObstacle(page, server) {
  const id = await storeField(server, { type: 'Feature', properties: { name: 'with a pond' }, geometry: polygonOf('slant') });
  const [w, s, wide, high] = [9.0008, 50.0004, 0.0004, 0.0002];
  const at = (x, y) => [w + x * wide, s + y * high];
  const pond = { type: 'Polygon', coordinates: [[at(0, 0), at(1, 0), at(1, 1), at(0, 1), at(0, 0)]] };
  await fetch(`${server.address}/api/v1/fields/${id}`, { method: 'PATCH', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ add: [{ kind: 'obstacle', geometry: pond }] }) });
  await page.goto(`${server.address}/?again#view=fields&field=${id}`);
  await mapReady(page);
  await page.getByText('1 obstacle').first().waitFor();
  await planTracks(page);
  await makePlan(page);
  await goTo(page, 'Fields');
  await page.getByText(/^Obstacles, as numbered/).click();
  await page.getByRole('button', { name: 'Change obstacle 1' }).click();

  const ground = wide * 111_320 * Math.cos((50 * Math.PI) / 180) * high * 111_240;
  const told = async () => Number(/; ([\d.,]+) m²/.exec(await page.locator('.drawing-bar').innerText())[1].replace(',', ''));
  const is = async (shares, why) => assert.ok(Math.abs((await told()) - shares * ground) < 0.01 * ground, `${why}: ${await told()} m² is not ${shares} × ${ground}`);
  await is(1, 'as it is stored');
  await drag(page, at(1, 1), at(1.5, 1));
  await is(1.25, 'a triangle at the corner that was moved');
  await drag(page, at(0.5, 0), at(0.5, -1));
  await is(1.75, 'a triangle below the new corner');
  await page.getByRole('button', { name: 'Delete the corner' }).click();
  await is(1.25, 'without it again');
  await page.getByRole('button', { name: 'Keep this obstacle' }).click();
  await page.locator('.drawing-bar').waitFor({ state: 'detached' });
  const { shapes, obstacles } = await ask(server, `/fields/${id}`);
  assert.equal(obstacles, 1, 'changed, not added');
  const [stored] = shapes.features.filter(({ properties }) => properties.kind === 'obstacle');
  assert.ok(Math.abs(stored.properties.area_m2 - 1.25 * ground) < 0.01 * ground, `${stored.properties.area_m2} m²`);
  await goTo(page, 'Plan');
  await page.getByText('of an earlier shape of the field').first().waitFor();
  await page.locator('.cards .card').first().click();
  await page.getByText('Plan again before you drive.').waitFor();
}
