import type { PlanFull, Tally } from '../../api/types';
import { change, count, degrees, hectares, length, money, percent, sentence, squareMetres } from '../../format';
import { Expander } from '../../parts/expander';
import { Figures, type Figure } from '../../parts/figures';
import { costOf, form } from '../../state/plan_form';
import { plans } from '../../state/plans';
import { useStore } from '../../state/store';

type Key = keyof Tally;
/** A wider gap between plan and bound says nothing. */
const TELLING = 0.3;

function costFigure(now: number, before: number | null): Figure {
  const told = before === null ? undefined : change(now - before, money);
  const same = told === undefined || told.startsWith('±');
  return { label: 'Cost', value: money(now), change: same && told ? 'as before' : told, better: same ? undefined : now < (before ?? now) };
}

export function PlanFigures({ plan }: { plan: PlanFull }) {
  const before = useStore(plans, (value) => value.before);
  const s = plan.summary;
  const prices = useStore(form, (value) => value);
  const cost = (counts: Tally) => costOf(counts, prices);
  const figure = (label: string, key: Key, write: (v: number) => string, tone?: Figure['tone']): Figure => {
    const by = before ? s[key] - before[key] : 0;
    const told = before ? change(by, write) : undefined;
    return {
      label, value: write(s[key]), change: told?.startsWith('±') ? 'as before' : told,
      better: told === undefined || told.startsWith('±') ? undefined : by < 0, ...(tone ? { tone } : {}),
    };
  };
  return (
    <section aria-label="The plan in numbers">
      <Figures label="The plan in numbers"
        list={[
          costFigure(cost(s), before ? cost(before) : null),
          figure('Overlap', 'overlap_m2', squareMetres, 'overlap'),
          figure('Uncovered', 'uncovered_m2', squareMetres, 'uncovered'),
          figure('Turns', 'turns', count),
          figure('Stops', 'stops', count),
          { label: 'Tracks', value: count(s.tracks), change: length(s.track_length_m) },
        ]} />
      <p class="hint">
        {`${hectares(s.body_m2)} to cover${s.direction_deg.length > 0 && s.direction_deg.length <= 4 ? `, tracks towards ${s.direction_deg.map(degrees).join(' and ')}` : ''}.`}
        {typeof s.gap === 'number' && s.gap < TELLING && ` No plan can be cheaper by more than ${percent(s.gap)}.`}
      </p>
      <Remarks plan={plan} />
    </section>
  );
}

function Remarks({ plan }: { plan: PlanFull }) {
  const { warnings = [], dropped = [] } = plan.summary;
  if (warnings.length + dropped.length === 0) return null;
  return (
    <Expander title={`Remarks (${warnings.length + (dropped.length > 0 ? 1 : 0)})`}>
      <ul class="plain">
        {warnings.map((warning, i) => <li key={i}>{sentence(warning)}</li>)}
        {dropped.length > 0 && <li>{dropped.length === 1 ? 'One piece was too short to be worth driving; its' : `${count(dropped.length)} pieces were too short to be worth driving; their`} land counts as uncovered.</li>}
      </ul>
    </Expander>
  );
}
