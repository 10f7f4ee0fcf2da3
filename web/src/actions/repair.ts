// From what was missed to a plan for it.
import { api } from '../api/client';
import { follow } from '../api/jobs';
import { form } from '../state/plan_form';
import { review } from '../state/review';
import { note } from './notices';
import { openPlan } from './plans';
import { stopReplay } from './play/replay';
import { show } from './session';
import { t } from '../words';

/** The repair plan of the open drive's gaps, shown in the plan view. */
export async function planTheGaps(least_m2: number): Promise<void> {
  const drive = review.get().drive;
  if (!drive) return;
  const { width_m, radius_m } = form.get().machine;
  try {
    const job = await api.startJob({ kind: 'repair', drive: drive.id, machine: { width_m, radius_m }, min_area_m2: least_m2 });
    const result = await follow(job, (state) => review.set({ job: state }));
    if (!result.plan) return;
    stopReplay();
    await openPlan(result.plan);
    show('plan');
    note(t`This is the plan for what was missed. Download it below, or go back to Review.`);
  } finally {
    review.set({ job: null });
  }
}
