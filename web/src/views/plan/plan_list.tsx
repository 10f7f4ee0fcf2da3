// The plans of the open field that are stored: the latest first.
import { attempt } from '../../actions/notices';
import { openPlan } from '../../actions/plans';
import { planThumbnail } from '../../api/addresses';
import type { PlanItem } from '../../api/types';
import { hours, money, plural, squareMetres, when, width } from '../../format';
import { Expander } from '../../parts/expander';
import { costOf, form } from '../../state/plan_form';
import { plans } from '../../state/plans';
import { useStore } from '../../state/store';
import { t } from '../../words';

const costs = (plan: PlanItem) => (plan.route ? `${money(plan.route.euros)} · ${hours(plan.route.hours)}` : t`tracks alone ${money(costOf(plan))}`);

export function PlanList() {
  useStore(form, (value) => value); // costs of tracks are counted at its prices
  const list = useStore(plans, (value) => value.list);
  const open = useStore(plans, (value) => value.open?.id);
  const coming = useStore(plans, (value) => value.coming);
  if (list.length === 0) return null;
  return (
    <section aria-label={t`Plans of this field`}>
      <Expander title={t`${plural(list.length, 'plan')} of this field`} open={open === undefined && !coming}>
        <ul class="cards scrolls" tabIndex={-1}>
          {list.map((plan) => (
            <li key={plan.id}>
              <button type="button" class="card" aria-current={plan.id === open} onClick={() => void attempt(() => openPlan(plan.id))}>
                <img class="thumb" src={planThumbnail(plan.id)} alt="" loading="lazy" />
                <span class="grow">
                  <strong>{plan.name}{plan.draft ? t` (draft)` : ''}</strong>
                  <span class="sub">{t`${when(plan.created)} · ${width(plan.width_m)} wide${plan.kind === 'repair' ? t` · repair` : ''}`}</span>
                  {plan.earlier_shape && <span class="sub fault">{t`of an earlier shape of the field`}</span>}
                  <span class="sub">{t`${costs(plan)} · ${squareMetres(plan.uncovered_m2)} uncovered`}</span>
                </span>
              </button>
            </li>
          ))}
        </ul>
      </Expander>
    </section>
  );
}
