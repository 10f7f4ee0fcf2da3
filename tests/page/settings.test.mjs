// Language, units and currency: chosen once, kept, and converted both ways.
import assert from 'node:assert/strict';
import { flow } from './support/flow.mjs';
import { goTo, makePlan, openField, panel } from './support/page.mjs';
import { ask, openId, polygonOf, smallField, storeField, storePlan } from './support/stored.mjs';

const value = (page, label) => page.locator('.figures > div', { has: page.locator('dt', { hasText: new RegExp(`^${label}$`) }) }).locator('.value').first().innerText();

flow('German by the browser, English by choice', { locale: 'de-DE' }, async ({ page, server }) => {
  await openField(page, smallField(server.folder), { file: 'Datei mit einem Feld wählen', open: /^Offenes Feld/ });
  assert.equal(await page.locator('html').getAttribute('lang'), 'de');
  assert.match(await panel(page).innerText(), /1,47 ha · keine Hindernisse/);
  await page.getByRole('navigation').getByRole('button', { name: 'Plan' }).click();
  await page.getByLabel('Arbeitsbreite').fill('4,5');
  await page.getByRole('button', { name: 'Plan erstellen' }).click();
  await page.getByRole('region', { name: 'Der Plan in Zahlen' }).waitFor({ timeout: 60_000 });
  assert.match(await value(page, 'Gesamtkosten'), /^[\d.]+,\d\d\s€$/);
  const plan = await ask(server, `/plans/${openId(page, 'plan')}`);
  assert.equal(plan.summary.width_m, 4.5);

  await page.getByRole('button', { name: 'Sprache und Einheiten' }).click();
  await Promise.all([page.waitForEvent('load'), page.getByRole('radio', { name: 'English' }).evaluate((radio) => radio.click())]);
  await page.getByRole('region', { name: 'The plan in numbers' }).waitFor();
  assert.match(await value(page, 'Whole cost'), /^€[\d,]+\.\d\d$/);
  await page.reload();
  await page.getByRole('region', { name: 'The plan in numbers' }).waitFor();
});

flow('what the program refuses and remarks is said in German, too', { locale: 'de-DE' }, async ({ page, server }) => {
  const bow = { type: 'Polygon', coordinates: [[[9, 50], [9.002, 50.001], [9.002, 50], [9, 50.0012], [9, 50]]] };
  const mended = await storeField(server, { type: 'Feature', properties: { name: 'Schleife' }, geometry: bow });
  await page.goto(`${server.address}/?again#view=fields&field=${mended}`);
  await page.getByText('Äußerer Ring berührte oder kreuzte sich selbst; behalten wurde, was eine ungerade Zahl von Malen umrundet wird').waitFor();

  const small = await storeField(server, { type: 'Feature', properties: { name: 'klein' }, geometry: polygonOf('slant') });
  const plan = await storePlan(server, small, 5, { width_m: 48, radius_m: 12 });
  const { warnings } = (await ask(server, `/plans/${plan}`)).summary;
  const [, share, m2] = /^([\d.]+) % of the land, (\d+) m², stays unworked$/.exec(warnings[0]);
  await page.goto(`${server.address}/?more#view=plan&field=${small}&plan=${plan}`);
  await page.getByText(/^Anmerkungen \(/).click();
  await page.getByText(`${share.replace('.', ',')} % der Fläche, ${m2} m², bleiben unbearbeitet.`).waitFor();
  await page.getByLabel('Arbeitsbreite', { exact: true }).fill('100');
  await page.getByLabel('Arbeitsbreite', { exact: true }).press('Enter');
  await page.getByRole('alert').filter({ hasText: /^In das Feld „klein“ .* passt keine Spur mit einer Arbeitsbreite von 100 m und Stücken von mindestens/ }).waitFor();
});

flow('feet, acres and dollars', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await page.getByRole('button', { name: 'Language and units' }).click();
  await page.getByRole('radio', { name: 'Feet, acres, gallons' }).evaluate((radio) => radio.click());
  await page.getByLabel('Currency').selectOption('USD');
  await page.getByLabel('A euro is worth').fill('1.25');
  await page.getByRole('button', { name: 'Done' }).click();
  const [field] = await ask(server, '/fields');
  // An acre is 4046.8564224 m².
  assert.match(await panel(page).innerText(), new RegExp(`${(field.area_m2 / 4046.8564224).toFixed(2).replace('.', '\\.')} ac`));

  await goTo(page, 'Plan');
  await page.getByLabel('Working width').fill('20');
  await page.getByLabel('Machine and driver').fill('125');
  await makePlan(page);
  const plan = await ask(server, `/plans/${openId(page, 'plan')}`);
  assert.ok(Math.abs(plan.summary.width_m - 6.096) < 1e-9, `${plan.summary.width_m} m`);
  assert.ok(Math.abs(plan.summary.whole_cost.rates.price_per_hour - 100) < 1e-9, 'a euro is a dollar and a quarter');
  const dollars = (plan.summary.whole_cost.euros * 1.25).toFixed(2);
  assert.equal((await value(page, 'Whole cost')).replaceAll(',', ''), `$${dollars}`);
  assert.match(await value(page, 'Fuel'), /gal$/);
  assert.match(await page.locator('.scale').innerText(), /ft/);
  await page.reload();
  assert.equal(await page.getByLabel('Working width').inputValue(), '20');
});

flow('a usual machine, by its name', {}, async ({ page, server }) => {
  await openField(page, smallField(server.folder));
  await goTo(page, 'Plan');
  await page.getByLabel('Usual machines').selectOption({ label: 'Planter, 8 rows of 75 cm' });
  assert.equal(await page.getByLabel('Working width').inputValue(), '6');
  await page.waitForFunction(() => [...document.querySelectorAll('select')].some((select) => select.value === 'seeding'));
  await makePlan(page);
  const { asked } = await ask(server, `/plans/${openId(page, 'plan')}`);
  assert.equal(asked.machine.turning.reverse, true);
  assert.equal(asked.machine.rates.sections, 8);
  await page.getByLabel('Working width').fill('5');
  assert.equal(await page.getByLabel('Usual machines').inputValue(), '', 'another width is none of them');
});
