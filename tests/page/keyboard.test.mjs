// From an empty store to a file for a terminal with the keyboard alone: no pointer, and nothing is focused by the test. At every step something has
// the focus, in sight and marked.
import assert from 'node:assert/strict';
import { flow, long } from './support/flow.mjs';
import { mapSettled, newPlan, planShown } from './support/page.mjs';
import { ask, openId } from './support/stored.mjs';

/** What has the focus: its name, whether it is marked, and whether it is in sight, a few frames after it got it. */
async function focused(page) {
  for (let i = 0; ; i++) {
    const at = await lookAtFocus(page);
    if (at.name === null || (at.marked && at.seen) || i === 20) return at;
    await page.waitForTimeout(50);
  }
}
const lookAtFocus = (page) =>
  page.evaluate(() => {
    const element = document.activeElement;
    if (!element || element === document.body) return { name: null };
    const label = element.labels?.[0];
    const name = (element.getAttribute('aria-label') ?? label?.textContent ?? element.textContent ?? '').trim();
    // Controls that are drawn by what stands beside them are marked there.
    const marks = [element, element.nextElementSibling, label, label?.querySelector('span')].filter(Boolean);
    const marked = marks.some((one) => {
      const { outlineStyle, outlineWidth } = getComputedStyle(one);
      return outlineStyle !== 'none' && parseFloat(outlineWidth) >= 2;
    });
    const seen = marks.some((one) => {
      const box = one.getBoundingClientRect();
      const [left, right] = [Math.max(box.left, 0), Math.min(box.right, innerWidth)];
      const [top, bottom] = [Math.max(box.top, 0), Math.min(box.bottom, innerHeight)];
      if (right - left < 4 || bottom - top < 4) return false;
      const over = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
      return marks.some((mark) => mark === over || mark.contains(over) || over?.contains(mark));
    });
    return { name, tag: element.tagName, marked, seen };
  });

/** Nothing is lost after a step, also not a little later. */
async function kept(page, after) {
  for (let i = 0; i < 3; i++) {
    const at = await focused(page);
    assert.notEqual(at.name, null, `the focus is lost after ${after}`);
    assert.ok(at.marked && at.seen, `after ${after} the focus cannot be seen: ${JSON.stringify(at)}`);
    await page.waitForTimeout(60);
  }
}

/** Presses Tab, or goes back with it, until the control with this name has the focus; whatever has it on the way is marked and in sight. */
async function tabTo(page, wanted, key = 'Tab') {
  let left = 0;
  for (let i = 0; i < 150; i++) {
    await page.keyboard.press(key);
    const at = await focused(page);
    if (at.name === null) {
      assert.ok(++left <= 1, `the focus is lost on the way to ${wanted}`);
      continue; // from the last control to the first the browser itself comes between
    }
    assert.ok(at.marked && at.seen, `on the way to ${wanted} the focus cannot be seen: ${JSON.stringify(at)}`);
    if (wanted.test(at.name)) return;
  }
  assert.fail(`${key} never comes to ${wanted}`);
}

async function enter(page, name) {
  await tabTo(page, name);
  await page.keyboard.press('Enter');
  await page.waitForTimeout(50);
}

/** From the form of a plan to its file for a display. */
async function planAndTake(page, server, machineFile) {
  await enter(page, /^Make the plan$/);
  await kept(page, 'Make the plan');
  await planShown(page);
  await page.waitForFunction(() => document.activeElement?.id === 'numbers');
  assert.match(await page.locator('p[role=status].unseen').innerText(), /^The plan is made: €[\d.,]+, /, 'it is read out');
  await kept(page, 'the plan is made');
  await tabTo(page, /^Which display\?$/);
  await page.keyboard.type(machineFile.typed);
  await kept(page, 'choosing the display');
  await tabTo(page, machineFile.button);
  const [file] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
  assert.match(file.suggestedFilename(), machineFile.name);
  await page.getByRole('status').filter({ hasText: 'is in your downloads' }).waitFor();
  await kept(page, 'taking the file');
  assert.equal((await ask(server, `/plans/${openId(page, 'plan')}`)).draft, false);
}

flow('the example farm, planned and taken to a terminal, by keyboard alone', {}, async ({ page, server }) => {
  await enter(page, /^Open the example farm$/);
  await page.getByRole('region', { name: 'Open field: Riverside' }).waitFor();
  await kept(page, 'Open the example farm');
  await enter(page, /^Roadside/);
  await page.getByRole('region', { name: 'Open field: Roadside' }).waitFor();
  await kept(page, 'opening a field');
  await tabTo(page, /^Plan this field$/, 'Shift+Tab');
  await page.keyboard.press('Enter');
  await kept(page, 'Plan this field');
  await planAndTake(page, server, { typed: 'CCI', button: /^Task set, ISOXML 4$/, name: /\.zip$/ });
});

flow('a field drawn, an area forbidden, tracks turned, a file taken, and a field by numbers, by keyboard alone', { skip: long }, async ({ page, server }) => {
  await enter(page, /^Draw a field$/);
  assert.equal((await focused(page)).tag, 'CANVAS', 'the map has the keyboard');
  await kept(page, 'Draw a field');
  await page.keyboard.press('+'); // a field of 2 ha is planned sooner than one of 9
  await mapSettled(page);
  // Enter sets a corner in the middle of the map, arrows move it: twice 100 px each way.
  const corners = async (steps) => {
    await page.keyboard.press('Enter');
    for (const key of steps) {
      for (let i = 0; i < 2; i++) {
        await page.keyboard.press(key);
        await mapSettled(page);
      }
      await page.keyboard.press('Enter');
    }
  };
  await corners(['ArrowRight', 'ArrowUp', 'ArrowLeft']);
  await page.locator('.drawing-bar [role=status]').filter({ hasText: '4 points set' }).waitFor();
  await enter(page, /^Store the field$/);
  await page.getByRole('region', { name: /^Open field/ }).waitFor();
  await kept(page, 'Store the field');
  await enter(page, /^Plan this field$/);
  await kept(page, 'Plan this field');
  await planAndTake(page, server, { typed: 'QG', button: /^Mission, \.plan$/, name: /\.plan$/ });

  await tabTo(page, /^Forbid an area$/, 'Shift+Tab');
  await page.keyboard.press('Enter');
  assert.equal((await focused(page)).tag, 'CANVAS');
  await page.keyboard.press('Escape');
  assert.equal((await focused(page)).name, 'Forbid an area', 'Escape goes back to what drawing began from');
  await turnTracks(page, server);
  await drawByNumbers(page, server);
});

async function drawByNumbers(page, server) {
  await tabTo(page, /^Fields$/, 'Shift+Tab');
  await page.keyboard.press('Enter');
  await enter(page, /^Draw a field$/);
  await tabTo(page, /^Or latitude and longitude in degrees/);
  for (const text of ['52.69 9.15', '200 0', '0 100', '-200 0']) {
    await page.keyboard.type(text);
    await page.keyboard.press('Enter');
    await kept(page, `typing ${text}`);
  }
  await enter(page, /^Store the field$/);
  await page.getByRole('region', { name: /^Open field/ }).waitFor();
  await kept(page, 'Store the field');
  // 200 m by 100 m.
  const [{ area_m2 }] = await ask(server, '/fields');
  assert.ok(Math.abs(area_m2 - 20_000) < 20, `${area_m2} m²`);
}

const plan = (page, server) => ask(server, `/plans/${openId(page, 'plan')}`);
const hash = (page) => new URL(page.url()).hash;
/** How far two directions are apart, in degrees. */
const apart = (a, b) => Math.abs(((((a - b) % 180) + 270) % 180) - 90);
/** The direction of the line that a plan was asked to follow. */
const lineOf = ({ asked }) => {
  const [[ax, ay], [bx, by]] = asked.settings.line;
  return (Math.atan2((bx - ax) * Math.cos((ay * Math.PI) / 180), by - ay) * 180) / Math.PI;
};

/** The plan that comes of what is done. */
async function nextPlan(page, server, act) {
  const before = hash(page);
  await act();
  await newPlan(page, before);
  return plan(page, server);
}

/** Tracks turned by keys: on the map's slider, where each key is a step to undo however long it is held, and as a number. */
async function turnTracks(page, server) {
  const first = openId(page, 'plan');
  await tabTo(page, /^Drag the direction$/, 'Shift+Tab');
  await page.keyboard.press('Enter');
  const slider = page.getByRole('slider', { name: 'Direction' });
  await slider.waitFor();
  assert.equal((await focused(page)).name, 'Direction', 'what turns the line has the keyboard');
  await kept(page, 'Drag the direction');
  const begin = parseFloat(await slider.getAttribute('aria-valuetext'));
  const turned = await nextPlan(page, server, async () => {
    for (let i = 0; i < 3; i++) await page.keyboard.down('ArrowRight'); // held: the second and third are repeats
    await page.keyboard.up('ArrowRight');
  });
  assert.ok(apart(lineOf(turned), begin + 3) < 0.1, `${lineOf(turned)}° is not ${begin}° and 3°`);
  assert.ok(apart(turned.summary.direction_deg[0], begin + 3) < 0.1);
  assert.ok(apart(parseFloat(await slider.getAttribute('aria-valuetext')), begin + 3) < 0.1);
  assert.equal((await focused(page)).name, 'Direction');
  const aside = await nextPlan(page, server, () => enter(page, /to the right$/));
  assert.ok(apart(lineOf(aside), lineOf(turned)) < 0.01);
  // A tenth of the width at right angles to the line.
  const [from, to] = [turned, aside].map(({ asked }) => asked.settings.line[0]);
  const [east, north] = [(to[0] - from[0]) * 111_320 * Math.cos((from[1] * Math.PI) / 180), (to[1] - from[1]) * 111_240];
  assert.ok(Math.abs(Math.hypot(east, north) - 0.1 * aside.summary.width_m) < 0.01, `${east} m, ${north} m`);
  assert.ok(apart((Math.atan2(east, north) * 180) / Math.PI, lineOf(turned) + 90) < 1);
  await enter(page, /^Keep this direction$/);
  await kept(page, 'Keep this direction');

  await tabTo(page, /^Direction$/);
  const fine = await nextPlan(page, server, () => page.keyboard.press('Shift+ArrowUp'));
  assert.ok(apart(lineOf(fine), begin + 3.1) < 0.11, `${lineOf(fine)}° is not ${begin}° and 3.1°`);
  await page.keyboard.press('Control+a');
  const typed = await nextPlan(page, server, async () => {
    await page.keyboard.type('37.5');
    await page.keyboard.press('Enter');
  });
  assert.ok(apart(lineOf(typed), 37.5) < 0.1, `${lineOf(typed)}°`);
  await kept(page, 'typing a direction');
  // Four steps, and before them the plan that nobody had a hand in.
  await tabTo(page, /^Undo the last step by hand$/);
  for (const before of [fine, aside, turned]) {
    const back = await nextPlan(page, server, () => page.keyboard.press('Enter'));
    assert.deepEqual(back.asked.settings.line, before.asked.settings.line);
  }
  await page.keyboard.press('Enter');
  await page.waitForFunction((id) => location.hash.includes(id), first);
}
