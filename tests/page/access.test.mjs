// With a keyboard alone, with a finger, and at arm's length.
import assert from 'node:assert/strict';
import { NARROW } from './support/browser.mjs';
import { flow } from './support/flow.mjs';
import { figure, goTo, makePlan, mapSettled, newPlan, openField, planShown, planTracks } from './support/page.mjs';
import { example } from './support/server.mjs';

/** Presses Tab until the control with this name has the focus. */
async function tabTo(page, name, role) {
  for (let i = 0; i < 120; i++) {
    await page.keyboard.press('Tab');
    const there = await page.evaluate(([wanted, kind]) => {
      const element = document.activeElement;
      const label = element?.getAttribute('aria-label') ?? element?.labels?.[0]?.textContent ?? element?.textContent ?? '';
      return new RegExp(wanted).test(label.trim()) && (!kind || element.matches(kind));
    }, [name, role ?? '']);
    if (there) return;
  }
  assert.fail(`Tab never comes to ${name}`);
}

flow('the way from a drawn field to a plan, by keyboard alone', {}, async ({ page }) => {
  await tabTo(page, '^Draw a field$');
  await page.keyboard.press('Enter');
  // The map has the focus now; Enter sets a corner in its middle, arrows move it.
  await page.waitForFunction(() => document.activeElement?.classList.contains('maplibregl-canvas'));
  await page.keyboard.press('Enter');
  for (const key of ['ArrowRight', 'ArrowUp', 'ArrowLeft']) {
    await page.keyboard.press(key);
    await page.keyboard.press(key);
    await mapSettled(page);
    await page.keyboard.press('Enter');
  }
  await page.locator('.drawing-bar', { hasText: '4 points set' }).waitFor();
  await tabTo(page, '^Store the field$');
  await page.keyboard.press('Enter');
  await page.getByRole('region', { name: /^Open field/ }).waitFor();
  await page.getByRole('link', { name: 'Skip to the panel' }).focus();
  await tabTo(page, '^Plan$', 'nav button');
  await page.keyboard.press('Enter');
  await tabTo(page, 'Swaths end', 'select');
  await page.keyboard.press('ArrowDown');
  await tabTo(page, '^Make the plan$');
  await page.keyboard.press('Enter');
  await planShown(page);
  assert.ok((await figure(page, 'Tracks')) > 0);
});

/** Everything that can be pressed, with its size as a finger finds it; and every text with its size. */
const measure = (page) =>
  page.evaluate(() => {
    const shown = (element) => element.checkVisibility({ checkOpacity: false, checkVisibilityCSS: true }) && element.getClientRects().length > 0;
    const small = [];
    const unnamed = [];
    for (const element of document.querySelectorAll('button, a[href], input, select, summary, [role=button]')) {
      if (!shown(element) || element.closest('.unseen') || element.classList.contains('unseen') || element.classList.contains('skip') || element.disabled) continue;
      const label = element.closest('label, .choice label');
      const boxes = [element, label, ...element.querySelectorAll('.target')].filter(Boolean).map((e) => e.getBoundingClientRect());
      const height = Math.max(...boxes.map((box) => box.height));
      const width = Math.max(...boxes.map((box) => box.width));
      const name = element.getAttribute('aria-label') || element.labels?.[0]?.textContent || element.textContent;
      if (height < 43.5 || width < 43.5) small.push(`${element.tagName} ${name}: ${width.toFixed(0)} × ${height.toFixed(0)}`);
      if (!name?.trim()) unnamed.push(element.outerHTML.slice(0, 120));
    }
    const tiny = [];
    const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walk.nextNode()) {
      const element = walk.currentNode.parentElement;
      if (!walk.currentNode.textContent.trim() || !shown(element) || element.closest('script, noscript, option')) continue;
      let size = parseFloat(getComputedStyle(element).fontSize);
      const svg = element.closest('svg');
      if (svg?.viewBox.baseVal?.width) size *= svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
      if (size < 12) tiny.push(`${walk.currentNode.textContent.trim()}: ${size.toFixed(1)} px`);
    }
    return { small, unnamed, tiny, wide: document.documentElement.scrollWidth - innerWidth };
  });

async function assertComfort(page, where) {
  await page.evaluate(() => document.querySelectorAll('details').forEach((details) => { details.open = true; }));
  // What opens may be filled when it has: two frames later everything stands where it stays.
  await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
  const { small, unnamed, tiny, wide } = await measure(page);
  assert.deepEqual(small, [], `${where}: targets of 44 px`);
  assert.deepEqual(unnamed, [], `${where}: every control has a name`);
  assert.deepEqual(tiny, [], `${where}: text of 12 px and more`);
  assert.ok(wide <= 0, `${where}: ${wide} px wider than the screen`);
}

flow('targets, names and sizes of text at 390 px', { viewport: NARROW, touch: true }, async ({ page }) => {
  await assertComfort(page, 'the first page');
  await page.getByLabel('Choose a file with a field').setInputFiles(example('two-farms.gpkg'));
  await page.getByLabel('Search by name, area or any other attribute').waitFor();
  await page.locator('.tick input').first().check();
  await assertComfort(page, 'a file of several fields');
  await page.getByRole('button', { name: 'Back' }).click();
  await openField(page, example('riverside.geojson'));
  await assertComfort(page, 'fields');
  await planTracks(page);
  await makePlan(page);
  await assertComfort(page, 'plan');
  const hash = new URL(page.url()).hash;
  await page.getByLabel('Working width', { exact: true }).fill('7');
  await newPlan(page, hash);
  await page.getByRole('button', { name: 'Check this plan' }).click();
  await page.getByText('The plan holds').waitFor({ timeout: 60_000 });
  await assertComfort(page, 'a draft that was checked');
  await page.getByRole('radio', { name: 'Tracks, by sliders' }).evaluate((radio) => radio.click());
  await assertComfort(page, 'plan with sliders');
  await page.getByRole('button', { name: 'Draw a line' }).evaluate((button) => button.click());
  await assertComfort(page, 'drawing');
  await page.locator('.drawing-bar').getByRole('button', { name: 'Cancel' }).click();
  await goTo(page, 'Compare');
  await page.getByRole('button', { name: 'Find the plans' }).click();
  await page.locator('.dot').first().waitFor({ timeout: 120_000 });
  await assertComfort(page, 'compare');
  await goTo(page, 'Review');
  await page.getByLabel('Choose the log of a machine').setInputFiles(example('riverside-drive.csv'));
  await page.getByRole('button', { name: 'Show what was worked' }).waitFor();
  await assertComfort(page, 'a log');
  await page.getByRole('button', { name: 'Show what was worked' }).click();
  await page.getByRole('group', { name: 'Replay' }).waitFor({ timeout: 60_000 });
  await assertComfort(page, 'review');
});

flow('on a phone nothing slides over the map, and a message is in sight wherever one is', { viewport: NARROW, touch: true, expected: [/status of 4/] }, async ({ page }) => {
  await openField(page, example('riverside.geojson'));
  await planTracks(page);
  await makePlan(page);
  const covered = await page.evaluate(async () => {
    const found = [];
    for (let y = 0; y < document.documentElement.scrollHeight - innerHeight; y += 40) {
      scrollTo(0, y);
      await new Promise((drawn) => requestAnimationFrame(drawn));
      const box = document.querySelector('.map').getBoundingClientRect();
      for (const part of [0.2, 0.5, 0.8]) {
        const at = document.elementFromPoint(box.left + box.width / 2, box.top + box.height * part);
        if (!at?.closest('.map')) found.push(`${y} px: ${at?.textContent}`);
      }
    }
    return found;
  });
  assert.deepEqual(covered, []);
  // From the end of the page: a width that no track fits into.
  await page.getByLabel('Working width', { exact: true }).fill('100');
  await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
  await page.getByLabel('Shortest piece').evaluate((input) => { input.value = '1000'; input.dispatchEvent(new Event('input', { bubbles: true })); });
  const message = page.getByRole('alert').filter({ hasText: 'no track fits' }).or(page.getByRole('alert').filter({ hasText: 'No track fits' }));
  await message.waitFor({ timeout: 60_000 });
  const box = await message.boundingBox();
  assert.ok(box.y > 0 && box.y + box.height < 844, `the message lies at ${box.y} px`);
  if (process.env.TRAMLINE_SHOTS) await page.screenshot({ path: `${process.env.TRAMLINE_SHOTS}/message.png` });
});

flow('day and night follow the system until one is chosen', { theme: 'dark' }, async ({ page }) => {
  const paper = () => page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  assert.equal(await paper(), 'rgb(18, 24, 26)');
  await page.getByRole('button', { name: 'Change to the day theme' }).click();
  assert.equal(await paper(), 'rgb(255, 255, 255)');
  await page.reload();
  await page.getByRole('heading', { name: 'Your fields' }).waitFor();
  assert.equal(await paper(), 'rgb(255, 255, 255)', 'it is remembered');
});
