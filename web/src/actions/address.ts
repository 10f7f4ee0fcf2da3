// What is open stands in the address, so that a reload and a bookmark open it again.
import { fields } from '../state/fields';
import { plans } from '../state/plans';
import { review } from '../state/review';
import { session, type View } from '../state/session';

export interface Opened {
  view: View;
  field: string | null;
  plan: string | null;
  drive: string | null;
}

const VIEWS: View[] = ['fields', 'plan', 'compare', 'review'];

export function readAddress(): Opened {
  const hash = new URLSearchParams(location.hash.slice(1));
  const view = VIEWS.find((name) => name === hash.get('view')) ?? 'fields';
  return { view, field: hash.get('field'), plan: hash.get('plan'), drive: hash.get('drive') };
}

/** What Back goes to: another view, or another field. */
const step = (opened: Opened) => `${opened.view}/${opened.field ?? ''}`;

function writeAddress(): void {
  if (restoring) return;
  const hash = new URLSearchParams({ view: session.get().view });
  const field = fields.get().open?.id;
  const plan = plans.get().open?.id;
  const drive = review.get().drive?.id;
  if (field) hash.set('field', field);
  if (plan) hash.set('plan', plan);
  if (drive) hash.set('drive', drive);
  const address = `#${hash.toString()}`;
  if (address === location.hash) return;
  const before = step(readAddress());
  if (before === step({ view: session.get().view, field: field ?? null, plan: null, drive: null })) history.replaceState(null, '', address);
  else history.pushState(null, '', address);
}

let restoring = false;

/** Writes what is open into the address; `goTo` opens what Back and Forward lead to. */
export function keepAddress(goTo: (opened: Opened) => Promise<void>): void {
  writeAddress();
  history.replaceState(null, '', location.hash);
  for (const from of [session, fields, plans, review]) from.listen(writeAddress);
  addEventListener('popstate', () => {
    restoring = true;
    void goTo(readAddress()).finally(() => {
      restoring = false;
      writeAddress();
    });
  });
}
