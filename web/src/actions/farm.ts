// Planning several fields with the machine and the settings of the form.
import { api } from '../api/client';
import { Cancelled, follow } from '../api/jobs';
import { ApiError } from '../api/errors';
import type { FieldItem } from '../api/types';
import { plural } from '../format';
import { farm } from '../state/farm';
import { fields } from '../state/fields';
import { form, OF_THE_FIELD, requestOf } from '../state/plan_form';
import { loadFields } from './fields';
import { complain, note } from './notices';
import { loadPlans } from './plans';
import { t } from '../words';

/** Jobs that the server runs at once. */
const AT_ONCE = 2;
let stopped = false;
let going = new Set<string>();

async function planOne(field: FieldItem): Promise<void> {
  const job = await api.startJob({ kind: 'plan', ...requestOf({ ...form.get(), ...OF_THE_FIELD }, field.id), explain: true });
  going.add(job.id);
  if (stopped) await api.cancelJob(job.id);
  try {
    await follow(job, () => {});
  } finally {
    going.delete(job.id);
  }
}

/** One after the other, two at a time. What cannot be planned is reported, and the others are planned all the same. */
export async function planFields(list: FieldItem[]): Promise<void> {
  stopped = false;
  going = new Set();
  const left = [...list];
  const failed: string[] = [];
  let done = 0;
  const tell = () => farm.set({ planning: { done, of: list.length, failed } });
  tell();
  const worker = async () => {
    for (let field = left.shift(); field && !stopped; field = left.shift()) {
      try {
        await planOne(field);
        done++;
      } catch (error) {
        if (error instanceof Cancelled) return;
        if (!(error instanceof ApiError) || error.away) {
          stopped = true; // the other worker must not go on behind the error
          throw error;
        }
        failed.push(`${field.name}: ${error.message}`);
      }
      tell();
    }
  };
  try {
    const ends = await Promise.allSettled(Array.from({ length: AT_ONCE }, worker));
    for (const end of ends) if (end.status === 'rejected') throw end.reason;
  } finally {
    farm.set({ planning: null, ticked: new Set() });
    await loadFields();
    const open = fields.get().open;
    if (open) await loadPlans(open.id);
  }
  note(stopped ? t`Planned: ${plural(done, 'field')}; you stopped the others.` : t`Planned: ${plural(done, 'field')}.`);
  if (failed.length > 0) complain(t`Could not be planned: ${plural(failed.length, 'field')}. ${failed.slice(0, 3).join(' ')}`);
}

export async function stopPlanning(): Promise<void> {
  stopped = true;
  await Promise.all([...going].map((job) => api.cancelJob(job).catch(() => {})));
}
