// A field and an obstacle drawn on the map, with the pointer and by numbers.
import assert from 'node:assert/strict';
import { flow } from './support/flow.mjs';
import { clickMap, drawn, figure, goTo, makePlan, panel, planTracks } from './support/page.mjs';

flow('draw a field and an obstacle, then plan', {}, async ({ page }) => {
  await page.getByRole('button', { name: 'Draw a field' }).click();
  const middle = await page.evaluate(() => window.tramlineMap.getCenter().toArray());
  const [w, h] = [0.0011, 0.0007];
  for (const [x, y] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) await clickMap(page, [middle[0] + x * w, middle[1] + y * h]);
  await page.getByRole('button', { name: 'Store the field' }).click();
  await page.getByRole('region', { name: /^Open field/ }).waitFor();
  // 0.0022° by 0.0014° at 51° north, 70.2 km and 111.25 km to a degree: 154.4 m by 155.8 m.
  assert.match(await panel(page).innerText(), /2\.4[01] ha · no obstacles/);

  await page.getByText('Add an obstacle').click();
  await page.getByLabel('How wide it is').fill('6');
  await page.getByRole('button', { name: 'Place it on the map' }).click();
  await clickMap(page, middle);
  await page.getByRole('button', { name: 'Add the obstacle' }).click();
  await page.getByText('1 obstacle').first().waitFor();
  assert.ok((await drawn(page, 'obstacle')) > 0);

  await planTracks(page);
  await makePlan(page);
  const tracks = await figure(page, 'Tracks');
  // 154 m across, 6 m wide: 26 tracks, and one or two more where the obstacle parts them.
  assert.ok(tracks >= 25 && tracks <= 30, `${tracks} tracks`);
});

flow('a field by numbers: a corner, then metres', {}, async ({ page }) => {
  await page.getByRole('button', { name: 'Draw a field' }).click();
  const type = async (text) => {
    await page.locator('.drawing-bar input').fill(text);
    await page.locator('.drawing-bar input').press('Enter');
  };
  await type('9.15 52.69');
  await type('200 0');
  await type('0 100');
  await type('-200 0');
  await page.getByRole('button', { name: 'Store the field' }).click();
  await page.getByRole('region', { name: /^Open field/ }).waitFor();
  assert.match(await panel(page).innerText(), /2\.00 ha/);
});
