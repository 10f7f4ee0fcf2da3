// Finding the trade-off of a field, laying its plans, and choosing two of them.
import { api } from '../api/client';
import { follow } from '../api/jobs';
import { compare } from '../state/compare';
import { fields } from '../state/fields';
import { compareRequestOf, form, USUAL, type CompareRequest } from '../state/plan_form';
import { plans } from '../state/plans';
import { landPrices } from '../state/rates';
import { keepPlan, loadPlans, openPlan } from './plans';

/** What is compared, and what of the form a comparison leaves out. */
export function comparison(field: string): CompareRequest {
  const value = form.get();
  const plan = plans.get().open;
  const passes = plan?.field === field ? (plan.explain?.routes?.[0]?.headlands ?? 0) : 0;
  return compareRequestOf(value, field, passes, landPrices(value.machine.rates, USUAL));
}

export async function makeFront(): Promise<void> {
  const field = fields.get().open;
  if (!field) return;
  try {
    const job = await api.startJob({ kind: 'compare', ...comparison(field.id).request });
    const result = await follow(job, (state) => compare.set({ job: state }));
    if (!result.front) return;
    compare.set({ frontId: result.front, front: await api.front(result.front), field: field.id, laid: {} });
  } finally {
    compare.set({ job: null });
  }
}

export async function cancelFront(): Promise<void> {
  const job = compare.get().job;
  if (job) await api.cancelJob(job.id);
}

export async function openPoint(point: number): Promise<void> {
  const { frontId, field } = compare.get();
  if (!frontId || !field) return;
  compare.set({ laying: point });
  try {
    let plan = compare.get().laid[point];
    if (plan === undefined) {
      plan = (await api.layPoint(frontId, point)).plan;
      compare.set({ laid: { ...compare.get().laid, [point]: plan } });
      await loadPlans(field);
    }
    await openPlan(plan);
  } finally {
    compare.set({ laying: null });
  }
}

export async function choose(side: 'a' | 'b', plan: string): Promise<void> {
  if (plan === '') return compare.set({ [side]: null });
  // What is laid beside another is wanted: no draft takes its place.
  if (plans.get().list.some((item) => item.id === plan && item.draft)) await keepPlan(plan);
  compare.set({ [side]: await api.plan(plan) });
}
