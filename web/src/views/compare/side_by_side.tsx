import { useEffect } from 'preact/hooks';
import { choose } from '../../actions/compare';
import { attempt } from '../../actions/notices';
import { deletePlan, openPlan } from '../../actions/plans';
import { planFile } from '../../api/addresses';
import type { PlanFull, PlanItem, PlanSummary } from '../../api/types';
import { change, count, endRule, hours, length, litres, money, percent, squareMetres, when, width } from '../../format';
import { Button } from '../../parts/button';
import { Select } from '../../parts/choice';
import { ConfirmButton } from '../../parts/confirm_button';
import { Expander } from '../../parts/expander';
import { Icon } from '../../parts/icon';
import { compare } from '../../state/compare';
import { costOf, form } from '../../state/plan_form';
import { plans } from '../../state/plans';
import { sameRates } from '../../state/rates';
import { useStore } from '../../state/store';
import { t } from '../../words';

const called = (plan: PlanItem, all: PlanItem[]) => {
  const number = all.length - all.indexOf(plan);
  return `${number} · ${money(plan.route ? plan.route.euros : costOf(plan))}${plan.route ? '' : t` tracks`} · ${plan.name || when(plan.created)}${plan.draft ? t` · draft` : ''}`;
};

export function SideBySide() {
  useStore(form, (value) => value); // costs are counted at its prices
  const list = useStore(plans, (value) => value.list);
  const { a, b } = { a: useStore(compare, (value) => value.a), b: useStore(compare, (value) => value.b) };
  const field = list[0]?.field;
  // The two newest plans are what one wants to compare first.
  useEffect(() => {
    const { a: left, b: right } = compare.get();
    const known = (plan: PlanFull | null) => plan !== null && list.some((item) => item.id === plan.id);
    const [newest, second] = list;
    if (!newest || !second || (known(left) && known(right) && left?.id !== right?.id)) return;
    void attempt(() => Promise.all([choose('a', second.id), choose('b', newest.id)]));
  }, [field, list.map((plan) => plan.id).join()]);
  if (list.length < 2) {
    return (
      <section>
        <h2>{t`Two plans side by side`}</h2>
        <p class="hint">{list.length === 1 ? t`This field has one plan so far. Make another under Plan, or click a dot above.` : t`This field has no plans yet. Make two under Plan, or click dots above.`}</p>
      </section>
    );
  }
  const options = list.map((plan) => ({ value: plan.id, label: called(plan, list) }));
  return (
    <section aria-labelledby="two-title">
      <h2 id="two-title">{t`Two plans side by side`}</h2>
      <div class="two">
        <Side side="a" title={t`First plan`} plan={a} options={options} />
        <Side side="b" title={t`Second plan`} plan={b} options={options} />
      </div>
      {a && b && a.id !== b.id && <Differences a={a} b={b} />}
      <AllPlans list={list} />
    </section>
  );
}

interface SideProps {
  side: 'a' | 'b';
  title: string;
  plan: PlanFull | null;
  options: { value: string; label: string }[];
}
const Side = ({ side, title, plan, options }: SideProps) => (
  <div>
    <Select label={title} value={plan?.id ?? ''} options={options} change={(id) => void attempt(() => choose(side, id))} />
    {plan && (
      <button type="button" class="picture" aria-label={t`${title}: show it on the map`} onClick={() => void attempt(() => openPlan(plan.id))}>
        <img src={planFile(plan.id, 'png')} alt={t`${title}: picture`} loading="lazy" />
      </button>
    )}
  </div>
);

interface Row {
  label: string;
  /** Null where the plan has no such figure; then nothing is compared. */
  of: (summary: PlanSummary) => number | null;
  write: (value: number) => string;
}
const costAtHand = (summary: PlanSummary) => costOf(summary);
const whole = (summary: PlanSummary) => summary.whole_cost;
const ROWS: Row[] = [
  { label: t`Whole cost`, of: (s) => whole(s)?.euros ?? null, write: money },
  { label: t`Time`, of: (s) => whole(s)?.hours ?? null, write: hours },
  { label: t`Fuel`, of: (s) => whole(s)?.litres ?? null, write: litres },
  { label: t`Cost of tracks`, of: costAtHand, write: money },
  { label: t`Overlap`, of: (s) => s.overlap_m2, write: squareMetres },
  { label: t`Of it outside`, of: (s) => s.outside_m2, write: squareMetres },
  { label: t`Uncovered`, of: (s) => s.uncovered_m2, write: squareMetres },
  { label: t`Turns`, of: (s) => s.turns, write: count },
  { label: t`Stops`, of: (s) => s.stops, write: count },
  { label: t`Tracks`, of: (s) => s.tracks, write: count },
  { label: t`Length of tracks`, of: (s) => s.track_length_m, write: length },
  { label: t`Detours`, of: (s) => s.detours, write: count },
  { label: t`Headland passes`, of: (s) => s.headland_passes, write: count },
];
const WORDS: { label: string; of: (summary: PlanSummary) => string }[] = [
  { label: t`Directions`, of: (s) => s.direction_deg.slice(0, 3).map((deg) => `${Math.round(deg)}°`).join(' ') + (s.direction_deg.length > 3 ? ' …' : '') },
  { label: t`End rule`, of: (s) => endRule(s.end_rule) },
  { label: t`Width`, of: (s) => width(s.width_m) },
];

function Compared({ row: { label, of, write }, one, two }: { row: Row; one: PlanSummary; two: PlanSummary }) {
  const [a, b] = [of(one), of(two)];
  if (a === null && b === null) return null;
  const difference = a === null || b === null || !alike(write, one, two) ? '' : change(b - a, write);
  return <tr><th scope="row">{label}</th><td>{a === null ? '–' : write(a)}</td><td>{b === null ? '–' : write(b)}</td><td>{difference}</td></tr>;
}

/** Money of whole jobs is compared where it was counted by the same rates. */
const alike = (write: Row['write'], one: PlanSummary, two: PlanSummary) =>
  write !== money || (!whole(one) && !whole(two)) || (whole(one) !== undefined && whole(two) !== undefined && sameRates(whole(one)!.rates, whole(two)!.rates));

/** Which plan is cheaper, of two that money can be compared of. */
function cheaper(one: PlanSummary, two: PlanSummary): { of: [number, number]; by: string } | null {
  const [a, b] = [whole(one), whole(two)];
  if (a && b) return sameRates(a.rates, b.rates) ? { of: [a.euros, b.euros], by: t`for the whole job, by the rates of the machine` } : null;
  return a || b ? null : { of: [costOf(one), costOf(two)], by: t`at the prices under Plan` };
}

function Differences({ a, b }: { a: PlanFull; b: PlanFull }) {
  const [one, two] = [a.summary, b.summary];
  const money_of = cheaper(one, two);
  const difference = money_of ? money_of.of[0] - money_of.of[1] : 0;
  return (
    <>
      {money_of === null && <p class="hint">{a.summary.whole_cost && b.summary.whole_cost ? t`What they cost is not compared: they were counted by different rates.` : t`What they cost is not compared: one is of the whole job, the other of tracks alone.`}</p>}
      {money_of && money(Math.abs(difference)) !== money(0) && (
        <p><strong>{difference > 0 ? t`The second plan is cheaper by ${money(Math.abs(difference))}` : t`The first plan is cheaper by ${money(Math.abs(difference))}`}</strong>{money_of.of[0] > 0 && `, ${percent(Math.abs(difference) / Math.max(...money_of.of))}`}, {money_of.by}.</p>
      )}
      <div class="wide-table" tabIndex={0} role="region" aria-label={t`Differences of the two plans`}>
        <table class="differences">
          <thead><tr><td /><th>{t`First`}</th><th>{t`Second`}</th><th>{t`Second − first`}</th></tr></thead>
          <tbody>
            {ROWS.map((row) => <Compared key={row.label} row={row} one={one} two={two} />)}
            {WORDS.map(({ label, of }) => (
              <tr key={label}><th scope="row">{label}</th><td>{of(one)}</td><td>{of(two)}</td><td>{of(one) === of(two) ? t`the same` : ''}</td></tr>
            ))}
          </tbody>
        </table>
      </div>
    </>
  );
}

function AllPlans({ list }: { list: PlanItem[] }) {
  const open = useStore(plans, (value) => value.open?.id);
  return (
    <Expander title={t`All plans of this field (${list.length})`}>
      <ul class="cards">
        {list.map((plan) => (
          <li key={plan.id} class="row tight">
            <Button aria-current={plan.id === open} onClick={() => void attempt(() => openPlan(plan.id))}>{called(plan, list)}</Button>
            <ConfirmButton label={t`Delete plan ${called(plan, list)}`} ask={t`Delete it`} act={() => void attempt(() => deletePlan(plan.id))}><Icon name="bin" /></ConfirmButton>
          </li>
        ))}
      </ul>
    </Expander>
  );
}
