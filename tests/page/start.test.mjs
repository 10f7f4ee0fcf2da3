// An empty store: the example farm, the tour, and the way to a terminal's file as a new user goes it.
import assert from 'node:assert/strict';
import { flow } from './support/flow.mjs';
import { panel } from './support/page.mjs';
import { ask } from './support/stored.mjs';

flow('from an empty store to a file for a terminal in five clicks', {}, async ({ page, server }) => {
  await page.getByRole('button', { name: 'Open the example farm' }).click();
  await page.getByRole('region', { name: 'Open field: Riverside' }).waitFor();
  assert.equal((await ask(server, '/fields')).length, 2);
  await page.getByRole('button', { name: /^Roadside/ }).click();
  await page.getByRole('region', { name: 'Open field: Roadside' }).waitFor();
  await page.getByRole('button', { name: 'Plan this field' }).click();
  await page.getByRole('button', { name: 'Make the plan' }).click();
  await page.locator('#numbers').waitFor({ timeout: 60_000 });
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('link', { name: /Shapefiles/ }).click()]);
  assert.match(file.suggestedFilename(), /\.zip$/);
});

flow('the tour goes through the views', {}, async ({ page }) => {
  await page.getByRole('button', { name: 'Take the short tour' }).click();
  for (const view of ['Fields', 'Plan', 'Compare', 'Review']) {
    assert.equal(await page.getByRole('navigation').locator('[aria-current=page]').innerText(), view);
    assert.match(await panel(page).innerText(), /[1-4] of 4\. /);
    await page.getByRole('region', { name: 'Tour' }).getByRole('button', { name: /^(Next|Done)$/ }).click();
  }
  assert.equal(await page.getByRole('region', { name: 'Tour' }).count(), 0);
});
