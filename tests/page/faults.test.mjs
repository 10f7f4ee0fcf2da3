// What goes wrong is told in a sentence that says what to do.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { flow } from './support/flow.mjs';
import { chooseFile, goTo, mapReady, openField, planTracks } from './support/page.mjs';
import { example } from './support/server.mjs';

const alert = (page) => page.getByRole('alert').first();
const isSentence = (text) => assert.match(text.trim(), /^[A-Z“].*[.!?]$/s);

flow('a file of garbage', { expected: [/400/] }, async ({ page, server }) => {
  const file = join(server.folder, 'garbage.geojson');
  writeFileSync(file, Buffer.from(Array.from({ length: 5000 }, (_, i) => (i * 7919) % 251)));
  for (const [view, label] of [['Fields', 'Choose a file with a field'], ['Review', 'Choose the log of a machine']]) {
    await goTo(page, view);
    await chooseFile(page, label, file);
    assert.match(await alert(page).innerText(), /^garbage\.geojson (contains no field|is not the log of a machine)\. Choose a .* file\./);
    await page.getByRole('button', { name: 'Dismiss this message' }).first().click();
  }
  // And the page goes on.
  await goTo(page, 'Fields');
  await openField(page, example('terrace.kml'));
});

flow('a log where a field belongs', {}, async ({ page }) => {
  await chooseFile(page, 'Choose a file with a field', example('riverside-drive.csv'));
  assert.match(await alert(page).innerText(), /log of a machine: drop it under Review\./);
});

flow('a file larger than the limit is not even sent', {}, async ({ page, server }) => {
  const limit = (await (await fetch(`${server.address}/api/v1`)).json()).limits.upload_bytes;
  let sent = 0;
  page.on('request', (request) => (sent += request.url().includes('/uploads') ? 1 : 0));
  await page.evaluate((size) => {
    const input = document.querySelector('.drop input');
    const data = new DataTransfer();
    const file = new File(['{}'], 'huge.geojson');
    Object.defineProperty(file, 'size', { value: size });
    data.items.add(file);
    // A list of files gives copies; the page has to see this one.
    Object.defineProperty(input, 'files', { value: [file] });
    input.dispatchEvent(new Event('change', { bubbles: true }));
  }, limit + 1);
  assert.match(await alert(page).innerText(), /huge\.geojson is .* MB large, but the server takes at most .* MB\./);
  assert.equal(sent, 0);
});

flow('a number that cannot be', {}, async ({ page }) => {
  await openField(page, example('terrace.kml'));
  await planTracks(page);
  const width = page.getByLabel('Working width');
  await width.fill('-3');
  assert.match(await page.locator('.fault').first().innerText(), /Type a number from 0\.2 to 100\./);
  assert.equal(await width.getAttribute('aria-invalid'), 'true');
});

flow('a wrong token, then the right one', { args: ['--token', 'open-sesame-1234567890'], path: '/#token=wrong', map: false, expected: [/40[13]/] }, async ({ page, server }) => {
  await page.getByRole('heading', { name: 'This page is locked' }).waitFor();
  await page.getByLabel('Token').fill('still-wrong');
  await page.getByRole('button', { name: 'Open the page' }).click();
  isSentence(await alert(page).innerText());
  await page.getByLabel('Token').fill('open-sesame-1234567890');
  await page.getByRole('button', { name: 'Open the page' }).click();
  await page.getByRole('heading', { name: 'Your fields' }).waitFor();
  await mapReady(page);

  await page.context().clearCookies();
  await page.goto(`${server.address}/?again#token=open-sesame-1234567890`);
  await page.getByRole('heading', { name: 'Your fields' }).waitFor();
  assert.ok(!page.url().includes('sesame'), 'the token does not stay in the address');
});

flow('the server is killed and comes back', { expected: [/ERR_CONNECTION/, /Failed to load/] }, async ({ page, server }) => {
  await openField(page, example('terrace.kml'));
  await server.kill();
  await page.getByText('The tramline server does not answer.').waitFor({ timeout: 15_000 });
  await server.again();
  await page.getByText('The tramline server does not answer.').waitFor({ state: 'detached', timeout: 15_000 });
  // What was saved is still there.
  await page.reload();
  await page.getByRole('region', { name: /^Open field/ }).waitFor();
});
