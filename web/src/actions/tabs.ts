// Another tab, or another computer, may have changed the store: what is shown follows when the page is looked at again.
import { api } from '../api/client';
import { ApiError } from '../api/errors';
import type { FieldFull } from '../api/types';
import { fields } from '../state/fields';
import { plans } from '../state/plans';
import { session } from '../state/session';
import { t } from '../words';
import { loadDrives } from './drives';
import { loadFields } from './fields';
import { loadMachines } from './machines';
import { note } from './notices';
import { closePlan, loadPlans } from './plans';

/** Null where it is gone. */
async function fieldNow(id: string): Promise<FieldFull | null> {
  try {
    return await api.field(id);
  } catch (error) {
    if (error instanceof ApiError && error.status === 404) return null;
    throw error;
  }
}

async function followField(open: FieldFull): Promise<void> {
  const now = await fieldNow(open.id);
  if (fields.get().open !== open) return; // the user has gone on meanwhile
  if (now === null) {
    closePlan();
    fields.set({ open: null });
    return note(t`This field was deleted elsewhere.`);
  }
  if (JSON.stringify(now) !== JSON.stringify(open)) fields.set({ open: now });
  const list = await loadPlans(open.id);
  const plan = plans.get().open;
  if (!plan || plan.field !== open.id || plans.get().job || list.some(({ id }) => id === plan.id)) return;
  plans.set({ open: null, before: null, layers: [], shapes: {} });
  note(t`This plan was deleted elsewhere.`);
}

async function lookAgain(): Promise<void> {
  await Promise.all([loadFields(), loadMachines(), loadDrives()]);
  const { open, busy } = fields.get();
  if (open && busy === null) await followField(open);
}

const LEAST_MS = 2000;
/** The lists were just loaded when this begins. */
export function followOtherTabs(): void {
  let last_ms = 0, timer = 0;
  const again = () => {
    clearTimeout(timer);
    if (document.hidden || !session.get().reachable || session.get().locked) return;
    const early_ms = last_ms + LEAST_MS - performance.now();
    if (early_ms > 0) {
      timer = window.setTimeout(again, early_ms);
      return;
    }
    last_ms = performance.now();
    void lookAgain().catch(() => {});
  };
  addEventListener('focus', again);
  document.addEventListener('visibilitychange', again);
}
