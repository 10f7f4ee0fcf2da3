// The page as a frame: what scrolls, where Back leads to, what Enter does, where the focus is.
import assert from 'node:assert/strict';
import { NARROW } from './support/browser.mjs';
import { flow } from './support/flow.mjs';
import { goTo, makePlan, openField, planTracks } from './support/page.mjs';
import { smallField } from './support/stored.mjs';

const TABLET = { width: 1024, height: 768 };

/** Counts what is asked of the server from now on. */
function plansAsked(page) {
  let asked = 0;
  page.on('request', (request) => (asked += request.method() === 'POST' && request.url().endsWith('/jobs') ? 1 : 0));
  return () => asked;
}

flow('Enter plans once, a number that cannot be never; the figures have the focus afterwards, and stay in sight beside the settings', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await planTracks(page);
  const asked = plansAsked(page);
  const width = page.getByLabel('Working width', { exact: true });
  await width.fill('-3');
  await width.press('Enter');
  await page.getByRole('alert').filter({ hasText: 'Working width cannot be so.' }).waitFor();
  await page.waitForTimeout(600);
  assert.equal(asked(), 0);
  await width.fill('5');
  await width.press('Enter');
  await page.waitForFunction(() => document.activeElement?.id === 'numbers');
  assert.match(await page.locator('p[role=status].unseen').innerText(), /^The plan is made: /);
  await page.waitForTimeout(600);
  assert.equal(asked(), 1);
  // With a plan on the map a change plans by itself: Enter after it is not a second time.
  await width.fill('4');
  await width.press('Enter');
  await page.waitForTimeout(1500);
  assert.equal(asked(), 2);

  // The frame stands still whatever is scrolled.
  await page.getByLabel('Each further subfield').focus();
  await page.evaluate(() => { scrollTo(0, 500); document.querySelector('main').scrollTo(0, 1e6); });
  assert.deepEqual(await page.evaluate(() => [scrollY, document.documentElement.scrollTop, document.body.scrollTop]), [0, 0, 0]);
  const bar = page.locator('.plan-bar');
  await bar.waitFor();
  // Layers arrive after the figures, and what is below moves once more.
  await page.waitForFunction(() => {
    const { y } = document.querySelector('.plan-bar').getBoundingClientRect();
    return y >= 60 && y < 200;
  });
  assert.match(await bar.innerText(), /€.*m² twice.*m² missed/s);
});

flow('Back goes to the view before, and to the field before', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await goTo(page, 'Plan');
  await openField2(page, server);
  await goTo(page, 'Compare');
  const view = () => page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get('view'));
  await page.goBack();
  await page.waitForFunction(() => location.hash.includes('view=fields'));
  assert.equal(await page.getByRole('navigation').locator('[aria-current=page]').innerText(), 'Fields');
  await page.goBack();
  await page.getByRole('region', { name: 'Open field: slant field' }).waitFor();
  await page.goBack();
  await page.waitForFunction(() => location.hash.includes('view=plan'));
  await page.goForward();
  await page.waitForFunction(() => location.hash.includes('view=fields'));
  assert.equal(await view(), 'fields');
});
async function openField2(page, server) {
  await goTo(page, 'Fields');
  await openField(page, smallField(server.folder, 'angle'));
  await page.getByRole('region', { name: 'Open field: angle field' }).waitFor();
}

flow('a phone opens each view at its top, and a tablet with the legend folded', { viewport: NARROW, touch: true }, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await planTracks(page);
  await makePlan(page);
  const scrolled = () => page.evaluate(() => { scrollTo(0, 900); return scrollY; });
  assert.ok((await scrolled()) > 0, 'the view is longer than the phone');
  await goTo(page, 'Fields');
  await page.waitForFunction(() => scrollY === 0);
  await goTo(page, 'Plan');
  assert.ok((await scrolled()) > 0);
  await page.reload();
  await page.getByLabel('The plan in numbers').first().waitFor();
  assert.equal(await page.evaluate(() => scrollY), 0);

  await page.setViewportSize(TABLET);
  await page.reload();
  await page.getByLabel('The plan in numbers').first().waitFor();
  assert.equal(await page.locator('.legend').evaluate((legend) => legend.open), false);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
});
