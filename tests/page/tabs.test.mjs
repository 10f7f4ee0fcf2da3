// Two tabs on one store, and the phone beside the computer.
import assert from 'node:assert/strict';
import { networkInterfaces } from 'node:os';
import { closePage, openPage } from './support/browser.mjs';
import { flow } from './support/flow.mjs';
import { goTo, makePlan, mapReady, openField, planTracks } from './support/page.mjs';
import { smallField } from './support/stored.mjs';

// The picture of a plan that was just deleted elsewhere cannot be loaded.
const expected = [/status of 404/];

flow('two tabs open on the same store', { expected }, async ({ page, server, browser }) => {
  await openField(page, smallField(server.folder));
  await planTracks(page);
  await makePlan(page);
  const other = await openPage(browser, server.address, { expected });
  await mapReady(other);
  await other.getByRole('button', { name: /^slant field/ }).click();
  await other.getByRole('region', { name: /^Open field/ }).waitFor();
  await goTo(other, 'Plan');
  await other.getByRole('region', { name: 'The plan in numbers' }).waitFor();

  // What one tab stores is there for the other as soon as it is looked at again.
  await page.getByLabel('Name of the plan').fill('of the first tab');
  await page.getByLabel('Name of the plan').press('Enter');
  await page.getByRole('region', { name: 'Open plan: of the first tab' }).waitFor();
  await goTo(page, 'Fields');
  await openField(page, smallField(server.folder, 'angle'));
  await goTo(other, 'Fields');
  await other.evaluate(() => window.dispatchEvent(new Event('focus')));
  await other.getByRole('button', { name: /^angle field/ }).waitFor();

  // A plan that one deletes is gone for the other, in words.
  await page.getByRole('button', { name: /^slant field/ }).click();
  await page.getByRole('region', { name: 'Open field: slant field' }).waitFor();
  await goTo(page, 'Plan');
  await page.getByRole('button', { name: /^Delete the plan/ }).click();
  await page.getByRole('button', { name: 'Delete it' }).click();
  await page.getByText('The plan is deleted.').waitFor();
  await goTo(other, 'Plan');
  await other.evaluate(() => window.dispatchEvent(new Event('focus')));
  await other.getByText('This plan was deleted elsewhere.').waitFor();
  assert.equal(await other.getByRole('region', { name: 'The plan in numbers' }).count(), 0);
  await closePage(other);
});

const reached = Object.values(networkInterfaces()).flat().find(({ family, internal }) => family === 'IPv4' && !internal);
flow('a code opens the plan on the phone', { args: ['--host', '0.0.0.0', '--token', 'of-the-farm-1'], path: '/#token=of-the-farm-1', skip: reached ? false : 'this machine has no address of its own' }, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await planTracks(page);
  await makePlan(page);
  const { addresses } = await page.evaluate(async () => (await fetch('/api/v1/session')).json());
  assert.ok(addresses[0].includes(reached.address), addresses.join());
  await page.getByRole('button', { name: 'Open it on the phone' }).click();
  const code = page.getByRole('img', { name: 'Code with the address of this plan' });
  await code.waitFor();
  // Version 5 and more: modules of a hundred letters, and three finders.
  assert.ok(Number((await code.getAttribute('viewBox')).split(' ')[2]) >= 37 + 4);
});
