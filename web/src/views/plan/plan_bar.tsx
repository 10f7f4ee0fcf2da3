// The figures of the plan in one line, while the settings are in sight and the figures themselves are not.
import { useEffect, useState } from 'preact/hooks';
import type { PlanFull } from '../../api/types';
import { hours, money, squareMetres } from '../../format';
import { costOf, form } from '../../state/plan_form';
import { plans } from '../../state/plans';
import { useStore } from '../../state/store';
import { t } from '../../words';

export function PlanBar({ plan }: { plan: PlanFull }) {
  useStore(form, (value) => value); // costs of tracks are counted at its prices
  const job = useStore(plans, (value) => value.job !== null);
  const [above, setAbove] = useState(false);
  useEffect(() => {
    const figures = document.getElementById('numbers');
    if (!figures) return;
    const watch = new IntersectionObserver(([seen]) => setAbove(seen !== undefined && !seen.isIntersecting && seen.boundingClientRect.top < innerHeight / 2));
    watch.observe(figures);
    return () => watch.disconnect();
  }, []);
  if (!above) return null;
  const s = plan.summary;
  const list = [
    s.whole_cost ? money(s.whole_cost.euros) : money(costOf(s)),
    ...(s.whole_cost ? [hours(s.whole_cost.hours)] : []),
    t`${squareMetres(s.overlap_m2)} twice`,
    t`${squareMetres(s.uncovered_m2)} missed`,
  ];
  return <div class={job ? 'plan-bar stale' : 'plan-bar'} aria-hidden="true">{list.map((text) => <span key={text}>{text}</span>)}</div>;
}
