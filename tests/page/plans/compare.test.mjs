// The trade-off with figures that a chart can stumble over, and comparisons of plans that leave something open.
import assert from 'node:assert/strict';
import { flow } from '../support/flow.mjs';
import { goTo, makePlan, newPlan, openField, panel, planTracks } from '../support/page.mjs';
import { ask, openId, smallField } from '../support/stored.mjs';

const point = (number, overlap_m2, uncovered_m2, turns = number) =>
  ({ point: number, overlap_m2, uncovered_m2, turns, stops: 0, cost: overlap_m2, tracks: 5, track_length_m: 500, subfields: 1, direction_deg: [10], marks: [] });

const FRONTS = {
  'nothing at all': [point(1, 0, 0), point(2, 0, 0)],
  'below zero by rounding': [point(1, -1e-5, 200), point(2, 30, -1e-5), point(3, 100, 0)],
  'one plan': [point(1, 1234, 56)],
  'two hundred plans': Array.from({ length: 200 }, (_, i) => point(i + 1, 4000 / (i + 1), 20 * i)),
};

/** Where the dots are, and whether every figure of the picture is a number. */
const picture = (page) =>
  page.locator('.chart svg').evaluate((svg) => ({
    bad: [...svg.querySelectorAll('*')].flatMap((part) => [...part.attributes]).filter(({ value }) => /NaN|Infinity/.test(value)).map(({ name, value }) => `${name}=${value}`),
    // By the number of the plan: they are drawn in another order.
    dots: [...svg.querySelectorAll('.dot')].map((dot) => ({ plan: Number(/^Plan (\d+):/.exec(dot.getAttribute('aria-label'))[1]), seen: dot.querySelector('.seen') }))
      .sort((a, b) => a.plan - b.plan).map(({ seen }) => [Number(seen.getAttribute('cx')), Number(seen.getAttribute('cy'))]),
    box: [svg.viewBox.baseVal.width, svg.viewBox.baseVal.height],
  }));

flow('the chart stands zeros, rounding below zero, one plan and two hundred', {}, async ({ page, server }) => {
  let front;
  await page.route(/api\/v1\/fronts\/[^/]+$/, async (route) => {
    const real = await (await route.fetch()).json();
    await route.fulfill({ json: { ...real, front } });
  });
  await openField(page, smallField(server.folder));
  await planTracks(page);
  await goTo(page, 'Compare');
  for (const [name, points] of Object.entries(FRONTS)) {
    front = points;
    await page.getByRole('button', { name: /^Find (the plans|them again)$/ }).click();
    await page.waitForFunction((many) => document.querySelectorAll('.chart .dot').length === many, points.length, { timeout: 60_000 });
    const { bad, dots, box } = await picture(page);
    assert.deepEqual(bad, [], name);
    assert.ok(dots.every(([x, y]) => x >= 0 && y >= 0 && x <= box[0] && y <= box[1]), `${name}: all dots lie in the picture`);
    // Where areas differ, dots do: along both axes, not on a line.
    for (const [axis, key] of [[0, 'overlap_m2'], [1, 'uncovered_m2']]) {
      const different = new Set(points.map((one) => Math.round(one[key]))).size;
      const apart = new Set(dots.map((dot) => dot[axis].toFixed(2))).size;
      assert.ok(apart >= Math.min(different, 3), `${name}: ${apart} places for ${different} values of ${key}`);
      // More lies farther to the right, and higher up.
      const sign = axis === 0 ? 1 : -1;
      points.forEach((a, i) => points.forEach((b, j) => {
        if (a[key] < b[key]) assert.ok(sign * dots[i][axis] <= sign * dots[j][axis] + 1e-6, `${name}: plan ${a.point} lies beyond plan ${b.point}`);
      }));
    }
  }
});

flow('a comparison of the whole job says at once what it leaves out, and does the rest', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await goTo(page, 'Compare');
  const told = page.getByRole('note');
  await told.waitFor();
  assert.match(await told.innerText(), /Tracks are compared by themselves/);
  assert.match(await told.innerText(), /All tracks are straight/);
  await page.getByRole('button', { name: 'Find the plans' }).click();
  await page.locator('.dot').first().waitFor({ timeout: 60_000 });
  assert.equal(await page.getByRole('alert').count(), 0);
});

flow('a plan along a line has its reasons, too; plans of different kinds are not compared by money', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await planTracks(page);
  const edge = page.getByLabel('Parallel to');
  await edge.selectOption({ label: await edge.locator('option', { hasText: /^edge 1:/ }).innerText() });
  await makePlan(page);
  await goTo(page, 'Compare');
  const text = await panel(page).innerText();
  assert.match(text, /Its tracks follow the line that you chose/);
  assert.match(text, /What its cost is made of/);

  await goTo(page, 'Plan');
  const hash = new URL(page.url()).hash;
  await page.getByRole('radio', { name: 'Whole job' }).evaluate((radio) => radio.click());
  await newPlan(page, hash);
  assert.ok((await ask(server, `/plans/${openId(page, 'plan')}`)).summary.whole_cost.euros > 0);
  await goTo(page, 'Compare');
  await page.getByRole('region', { name: 'Differences of the two plans' }).waitFor();
  assert.match(await panel(page).innerText(), /one is of the whole job, the other of tracks alone/);
  const rows = await page.getByRole('region', { name: 'Differences of the two plans' }).locator('tbody tr').evaluateAll((all) => Object.fromEntries(all.map((row) => [row.cells[0].innerText, row.cells[3].innerText])));
  assert.equal(rows['Whole cost'], '');
  assert.match(rows.Overlap, /^[+−±]/);
});
