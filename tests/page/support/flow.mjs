// A browser for a file of tests, and a server and a page for each of its flows.
import { after, before, test } from 'node:test';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { closePage, openPage, startBrowser } from './browser.mjs';
import { mapReady } from './page.mjs';
import { startServer } from './server.mjs';

let browser;
before(async () => {
  browser = await startBrowser();
});
after(() => browser?.close());

/** flow('what a user does', {page options, args}, async ({page, server}) => …) */
export function flow(name, options, run) {
  test(name, { timeout: options.timeout ?? 240_000, skip: options.skip ?? false }, async () => {
    const server = await startServer({ args: options.args ?? [] });
    try {
      const page = await openPage(browser, server.address + (options.path ?? '/'), options);
      try {
        if (options.map !== false) await mapReady(page);
        await run({ page, server, browser });
      } catch (error) {
        if (process.env.TRAMLINE_SHOTS) await page.screenshot({ path: join(process.env.TRAMLINE_SHOTS, `${name.replace(/\W+/g, '-')}.png`) });
        error.message += `\nbackground: ${JSON.stringify(page.faults)}`;
        await page.context().close();
        throw error;
      }
      await closePage(page);
    } finally {
      await server.stop();
    }
  });
}

/** Why flows are skipped that make others' way again on other data, or take long; false in `make long-page`. */
export const long = process.env.TRAMLINE_LONG ? false : 'takes its time: make long-page';

/** A file of real data, or why the test is skipped. */
export function realFile(...parts) {
  const folder = process.env.TRAMLINE_DATA;
  if (!folder) return { skip: 'TRAMLINE_DATA is not set: no real fields and logs here' };
  const file = join(folder, ...parts);
  return existsSync(file) ? { file, skip: false } : { skip: `${file} is not there` };
}
