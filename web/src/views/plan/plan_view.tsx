import { attempt } from '../../actions/notices';
import { cancelPlan, makePlan } from '../../actions/planning';
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
import { MachineForm } from './machine_form';
import { PlanFigures } from './plan_figures';
import { PlanFiles } from './plan_files';
import { PlanHead } from './plan_head';
import { PlanList } from './plan_list';
import { RouteFigures } from './route_figures';
import { RouteForm } from './route_form';
import { TracksForm } from './tracks_form';

export function PlanView() {
  const field = useStore(fields, (value) => value.open);
  const open = useStore(plans, (value) => value.open);
  const job = useStore(plans, (value) => value.job);
  const again = useStore(form, (value) => value.again);
  if (!field) return <NoField />;
  return (
    <>
      {open && <PlanHead plan={open} />}
      {open && <PlanFigures plan={open} />}
      {open?.summary.route && <RouteFigures route={open.summary.route} />}
      <PlanList />
      <form onSubmit={(event) => { event.preventDefault(); void attempt(() => makePlan()); }}>
        <MachineForm />
        <CostsForm />
        <EndsForm />
        <TracksForm />
        <RouteForm />
        <div class={open && !job ? 'sticky' : 'sticky foot'}>
          {job ? (
            <Progress job={job} title="Planning" cancel={() => void attempt(cancelPlan)} />
          ) : (
            <button type="submit" class="button main wide">{open ? 'Plan again' : 'Make the plan'}</button>
          )}
        </div>
        <Switch on={again} label="Plan again automatically when something changes" change={(on) => form.set({ again: on })} />
      </form>
      {open && <CheckPlan plan={open} />}
      {open && <PlanFiles plan={open} />}
    </>
  );
}
