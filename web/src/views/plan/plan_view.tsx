import { attempt, complain } from '../../actions/notices';
import { cancelPlan, makePlan } from '../../actions/planning';
import type { PlanFull } from '../../api/types';
import { hours, money, plural, squareMetres } from '../../format';
import { Progress } from '../../parts/progress';
import { Switch } from '../../parts/switch';
import { fields } from '../../state/fields';
import { form } from '../../state/plan_form';
import { plans } from '../../state/plans';
import { useStore } from '../../state/store';
import { NoField } from '../no_field';
import { CheckPlan } from './check_plan';
import { CostsForm } from './costs_form';
import { EndsForm } from './ends_form';
import { HandForm } from './hand_form';
import { MachineForm } from './machine_form';
import { PlanBar } from './plan_bar';
import { PlanFigures } from './figures/plan_figures';
import { PlanFiles } from './plan_files';
import { PlanHead } from './plan_head';
import { PlanList } from './plan_list';
import { RepairCosts } from './figures/repair_costs';
import { RouteFigures } from './figures/route_figures';
import { RouteForm } from './route_form';
import { TakeAlong } from './take_along';
import { TracksForm } from './tracks_form';
import { t } from '../../words';

/** What is read out when a plan is there. */
const spoken = ({ summary: s }: PlanFull) =>
  s.whole_cost
    ? t`The plan is made: ${money(s.whole_cost.euros)}, ${hours(s.whole_cost.hours)}, ${squareMetres(s.uncovered_m2)} uncovered.`
    : t`The plan is made: ${plural(s.tracks, 'track')}, ${squareMetres(s.overlap_m2)} overlap, ${squareMetres(s.uncovered_m2)} uncovered.`;

/** A number that cannot be is looked at first; afterwards the figures have the focus. */
function submit(settings: HTMLFormElement): void {
  const wrong = settings.querySelector<HTMLInputElement>('[aria-invalid=true]');
  if (wrong) {
    wrong.closest('details')?.setAttribute('open', '');
    wrong.focus();
    return complain(t`${wrong.labels?.[0]?.textContent ?? t`A number`} cannot be so. Correct it, then plan again.`);
  }
  void attempt(() => makePlan()).then((made) => {
    if (made && (document.activeElement === null || document.activeElement === document.body || settings.contains(document.activeElement))) document.getElementById('numbers')?.focus();
  });
}

export function PlanView() {
  const field = useStore(fields, (value) => value.open);
  const open = useStore(plans, (value) => value.open);
  const job = useStore(plans, (value) => value.job);
  const again = useStore(form, (value) => value.again);
  if (!field) return <NoField />;
  return (
    <>
      <p class="unseen" role="status">{open && !job ? spoken(open) : ''}</p>
      {open && <PlanHead plan={open} />}
      {open && <PlanFigures plan={open} />}
      {open?.explain?.repair && <RepairCosts repair={open.explain.repair} />}
      {open && <PlanBar plan={open} />}
      {open?.summary.route && <RouteFigures plan={open} route={open.summary.route} />}
      {open && open.kind !== 'repair' && <HandForm plan={open} />}
      <PlanList />
      <form onSubmit={(event) => { event.preventDefault(); submit(event.currentTarget); }}>
        <MachineForm />
        <CostsForm />
        <EndsForm />
        <TracksForm />
        <RouteForm />
        <div class={open && !job ? 'sticky' : 'sticky foot'}>
          {job ? (
            <Progress job={job} title={t`Planning`} cancel={() => void attempt(cancelPlan)} />
          ) : (
            <button type="submit" class="button main wide">{open ? t`Plan again` : t`Make the plan`}</button>
          )}
        </div>
        <Switch on={again} label={t`Plan again automatically when something changes`} change={(on) => form.set({ again: on })} />
      </form>
      {open && <CheckPlan plan={open} />}
      {open && <TakeAlong plan={open} />}
      {open && <PlanFiles plan={open} />}
    </>
  );
}
