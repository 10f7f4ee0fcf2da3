// From the first request to what was open last.
import { api } from '../api/client';
import { fields } from '../state/fields';
import { plans } from '../state/plans';
import { review } from '../state/review';
import { session } from '../state/session';
import { keepAddress, readAddress, type Opened } from './address';
import { loadDrives, openDrive } from './drives';
import { awaitTakenUp } from './feeds';
import { loadFields, openField } from './fields';
import { loadMachines } from './machines';
import { attempt } from './notices';
import { loadPlans, openPlan } from './plans';
import { loadUsualRates } from './rates';
import { greet } from './server';
import { show } from './session';
import { followOtherTabs } from './tabs';

const opened = readAddress();
let kept = false;

/** Loads what the server keeps, and opens what the address names. */
export async function start(): Promise<void> {
  if (!(await greet())) return;
  await Promise.all([loadFields, loadMachines, loadDrives, loadUsualRates].map(attempt));
  if (kept) return;
  kept = true;
  session.set({ view: opened.view });
  const { field, plan, drive } = opened;
  // What the address names may be gone by now: then the page simply opens without it.
  if (field) await openField(field, plan).catch(() => {});
  else if (plan) await openPlan(plan).catch(() => {});
  if (drive) await openDrive(drive).catch(() => {});
  keepAddress(goBack);
  followOtherTabs();
}

/** Opens what stood in the address before. */
async function goBack({ view, field, plan, drive }: Opened): Promise<void> {
  show(view);
  if (field && field !== fields.get().open?.id) await openField(field, plan).catch(() => {});
  else if (plan && plan !== plans.get().open?.id) await openPlan(plan).catch(() => {});
  if (drive && drive !== review.get().drive?.id) await openDrive(drive).catch(() => {});
}

/** Gives the server the token that was typed, and begins anew. */
export async function unlock(token: string): Promise<void> {
  await api.session(token);
  await start();
}

/** After the server has been away. */
export async function comeBack(): Promise<void> {
  await start();
  const open = fields.get().open;
  if (open) await loadPlans(open.id).catch(() => {});
  await awaitTakenUp().catch(() => {});
}
