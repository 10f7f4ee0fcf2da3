// The jobs that make a plan and check it.
import { api } from '../api/client';
import { follow } from '../api/jobs';
import type { Job } from '../api/types';
import { fields } from '../state/fields';
import { butForTheHand, form, isShowing, requestOf } from '../state/plan_form';
import { bestOf, hand, type Best } from '../state/hand';
import { plans } from '../state/plans';
import { attempt, note } from './notices';
import { loadPlans, openPlan, showPlan } from './plans';
import { t } from '../words';

let run = 0;
let timer = 0;

/** While somebody has a hand on the plan, the next one is to be seen at once. */
const AT_ONCE_S = 1;
function soon(): { seconds?: number } {
  const { past, future } = hand.get();
  return past.length + future.length > 0 ? { seconds: AT_ONCE_S } : {};
}

/** Whether edits can begin from the plan: it is stored, and of the shape that the field has now. */
export const editable = (plan: string) => plans.get().list.some((item) => item.id === plan && !item.earlier_shape);

/** After a reload, what the plan on the map was an edit of. */
async function foundBest(): Promise<Best | null> {
  const first = plans.get().open?.asked?.edit_of;
  if (!first || !editable(first)) return null;
  const best = bestOf(await api.plan(first), form.get());
  hand.set({ best });
  return best;
}

/** The plan that the next one is an edit of; null where it has to be planned anew. */
async function editOf(field: string): Promise<string | null> {
  const { past, future } = hand.get();
  const best = hand.get().best ?? await foundBest();
  if (past.length + future.length === 0 || best?.field !== field || !editable(best.plan) || best.asked !== butForTheHand(form.get(), field)) return null;
  return best.plan;
}

/** Makes a plan as the form says, which the next one replaces if it is a draft; a run that is still going on is cancelled first. */
export async function makePlan(draft = false): Promise<void> {
  const field = fields.get().open;
  if (!field) return;
  const mine = ++run;
  clearTimeout(timer); // what is planned now needs no second time
  await endGoing();
  const first = draft ? await editOf(field.id) : null;
  if (mine !== run) return;
  const job = await api.startJob({
    kind: 'plan', ...requestOf(form.get(), field.id), ...(first === null ? { explain: true } : { edit_of: first }), ...(draft ? { draft, ...soon() } : {}),
  });
  await finish(job, mine, showPlan);
}

async function endGoing(): Promise<void> {
  const going = plans.get().job;
  if (going) await api.cancelJob(going.id).catch(() => {});
}

/** What is being planned is not wanted any more. */
export async function dropPlanning(): Promise<void> {
  ++run;
  clearTimeout(timer);
  await endGoing();
  plans.set({ job: null });
}

/** Follows a job to its plan, and shows that if its field is still the open one. */
async function finish(job: Job, mine: number, open: (plan: string) => Promise<unknown>): Promise<void> {
  const field = job.field;
  try {
    const result = await follow(job, (state) => mine === run && plans.set({ job: state }));
    if (mine !== run || !result.plan) return;
    if (fields.get().open?.id !== field) return note(t`The plan of the field before is made: it opens with its field.`);
    await open(result.plan);
    await loadPlans(field);
  } catch (error) {
    if (mine === run) throw error;
  } finally {
    if (mine === run) plans.set({ job: null });
  }
}

/** A plan of the field that is being made already, as after a reload, is shown when it is there. */
export async function takeUpPlanning(field: string): Promise<void> {
  if (plans.get().job) return;
  const going = (await api.jobs()).find((job) => job.kind === 'plan' && job.field === field && (job.state === 'queued' || job.state === 'running'));
  if (going && !plans.get().job) await finish(going, ++run, openPlan);
}

export async function cancelPlan(): Promise<void> {
  const job = plans.get().job;
  if (job) await api.cancelJob(job.id);
}

/** Works the plan out anew on the server, by another road than the one that made it. */
export async function checkPlan(id: string): Promise<void> {
  try {
    const { check } = await follow(await api.startJob({ kind: 'check', plan: id }), (job) => plans.set({ checking: job }));
    if (check) plans.set({ checked: { plan: id, check } });
  } finally {
    plans.set({ checking: null });
  }
}
export async function cancelCheck(): Promise<void> {
  const job = plans.get().checking;
  if (job) await api.cancelJob(job.id);
}

const PAUSE_MS = 350;

/** What a plan comes out by: the name of a machine changes nothing. */
function whatMatters(field: string): string {
  const { machine: { name: _, ...machine }, ...rest } = requestOf(form.get(), field);
  return JSON.stringify({ ...rest, machine });
}

/** Once a plan is there, changes of the form make the next one by themselves. */
export function planAtChanges(): void {
  let last = '';
  form.listen(() => {
    const field = fields.get().open;
    const asked = field ? whatMatters(field.id) : '';
    if (asked === last) return;
    last = asked;
    clearTimeout(timer);
    const open = plans.get().open;
    if (isShowing() || !form.get().again || !field || !open || open.field !== field.id) return;
    timer = window.setTimeout(() => void attempt(() => makePlan(true)), PAUSE_MS);
  });
}

/** The next plan has one direction, as this line. */
export async function planAlong(line: [number, number][]): Promise<void> {
  const planned = form.get().again && plans.get().open !== null;
  form.set({ line, shape: 'straight' });
  if (!planned) await makePlan(true);
}
