// From the first request to what was open last.
import { keepAddress, readAddress } from './state/address';
import { loadFields, openField } from './state/fields';
import { attempt } from './state/notices';
import { loadMachines, loadPlans, openPlan } from './state/plans';
import { loadDrives, openDrive } from './state/review';
import { greet, session } from './state/session';
import { fields } from './state/fields';

const opened = readAddress();
let kept = false;

/** Loads what the server keeps, and opens what the address names. */
export async function start(): Promise<void> {
  if (!(await greet())) return;
  await Promise.all([loadFields, loadMachines, loadDrives].map(attempt));
  if (kept) return;
  kept = true;
  session.set({ view: opened.view });
  const { field, plan, drive } = opened;
  // What the address names may be gone by now: then the page simply opens without it.
  if (field) await openField(field).catch(() => {});
  if (plan) await openPlan(plan).catch(() => {});
  if (drive) await openDrive(drive).catch(() => {});
  keepAddress();
}

/** After the server has been away. */
export async function comeBack(): Promise<void> {
  await start();
  const open = fields.get().open;
  if (open) await loadPlans(open.id).catch(() => {});
}
