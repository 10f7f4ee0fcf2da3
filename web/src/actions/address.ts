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

function writeAddress(): void {
  const hash = new URLSearchParams({ view: session.get().view });
  const field = fields.get().open?.id;
  const plan = plans.get().open?.id;
  const drive = review.get().drive?.id;
  if (field) hash.set('field', field);
  if (plan) hash.set('plan', plan);
  if (drive) hash.set('drive', drive);
  history.replaceState(null, '', `#${hash.toString()}`);
}

export function keepAddress(): void {
  for (const from of [session, fields, plans, review]) from.listen(writeAddress);
}
