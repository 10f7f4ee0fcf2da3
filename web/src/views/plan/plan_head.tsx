// Which plan is open: its name, whether it stays, and how to be rid of it.
import { attempt, note } from '../../actions/notices';
import { deletePlan, keepPlan, renamePlan } from '../../actions/plans';
import type { PlanFull } from '../../api/types';
import { Button } from '../../parts/button';
import { ConfirmButton } from '../../parts/confirm_button';
import { Icon } from '../../parts/icon';
import { TitleField } from '../../parts/title_field';
import { t } from '../../words';

export function PlanHead({ plan }: { plan: PlanFull }) {
  const remove = async () => {
    await deletePlan(plan.id);
    note(t`The plan is deleted. Make another one, or open another plan of this field under Compare.`);
  };
  return (
    <section class="plan-head" aria-label={t`Open plan: ${plan.name}`}>
      <div class="row tight">
        <TitleField key={plan.id} label={t`Name of the plan`} value={plan.name} save={(name) => void attempt(() => renamePlan(plan.id, name))} />
        <ConfirmButton label={t`Delete the plan ${plan.name}`} ask={t`Delete it`} act={() => void attempt(remove)}><Icon name="bin" /></ConfirmButton>
      </div>
      {plan.earlier_shape && <p class="notice error">{t`This plan is of an earlier shape of the field. Plan again before you drive.`}</p>}
      {plan.draft && (
        <div class="between">
          <p class="hint">{t`A draft: the next change replaces it, unless you keep, name or download it.`}</p>
          <Button onClick={() => void attempt(() => keepPlan(plan.id))}>{t`Keep it`}</Button>
        </div>
      )}
    </section>
  );
}
