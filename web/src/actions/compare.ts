// Finding the trade-off of a field, laying its plans, and choosing two of them.
import { api } from '../api/client';
import { follow } from '../api/jobs';
import { compare } from '../state/compare';
import { fields } from '../state/fields';
import { form, requestOf } from '../state/plan_form';
import { plans } from '../state/plans';
import { keepPlan, loadPlans, openPlan } from './plans';

export async function makeFront(): Promise<void> {
  const field = fields.get().open;
  if (!field) return;
  try {
    const job = await api.startJob({ kind: 'compare', ...requestOf(form.get(), field.id) });
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
