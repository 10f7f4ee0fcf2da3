import type { PlanFull, PlanSummary, WholeCost } from '../../../api/types';
import { change, count, degrees, hectares, hours, length, litres, money, percent, plural, sentence, squareMetres } from '../../../format';
import { Expander } from '../../../parts/expander';
import { Figures, type Figure } from '../../../parts/figures';
import { costOf, form } from '../../../state/plan_form';
import { plans } from '../../../state/plans';
import { sameRates } from '../../../state/rates';
import { useStore } from '../../../state/store';
import { CostParts } from './cost_parts';
import { HeadlandDepths } from './headland_depths';
import { OneDirection } from './one_direction';
import { told } from '../../../program_words';
import { t } from '../../../words';

/** A wider gap between plan and bound says nothing. */
const TELLING = 0.3;
const SAME_LAND_M2 = 1;

interface Row {
  label: string;
  of: (summary: PlanSummary) => number;
  write: (value: number) => string;
  tone?: Figure['tone'];
  note?: string | undefined;
  /** Hours and litres can be compared where money cannot. */
  money?: false;
}

/** A value, and by how much it differs from a plan that it can be compared with. */
function figure({ label, of, write, tone, note }: Row, now: PlanSummary, before: PlanSummary | null): Figure {
  const by = before ? of(now) - of(before) : 0;
  const told = before ? change(by, write) : undefined;
  const same = told?.startsWith('±');
  return { label, value: write(of(now)), change: same ? t`as before` : told, better: told === undefined || same ? undefined : by < 0, note, ...(tone ? { tone } : {}) };
}

const whole = (summary: PlanSummary): WholeCost => summary.whole_cost!;

/** Figures of the same land are alike; money is where it was counted by the same rates. */
const sameLand = (a: PlanSummary, b: PlanSummary) => Math.abs(a.area_m2 - b.area_m2) < SAME_LAND_M2;
const bothWhole = (a: PlanSummary, b: PlanSummary) => a.whole_cost !== undefined && b.whole_cost !== undefined;
const sameMoney = (a: PlanSummary, b: PlanSummary) => bothWhole(a, b) ? sameRates(whole(a).rates, whole(b).rates) : !a.whole_cost && !b.whole_cost;

export function PlanFigures({ plan }: { plan: PlanFull }) {
  const last = useStore(plans, (value) => value.before);
  const prices = useStore(form, (value) => value);
  const s = plan.summary;
  const before = last && sameLand(last, s) ? last : null;
  const costs: Row[] = s.whole_cost
    ? [
        { label: t`Whole cost`, of: (x) => whole(x).euros, write: money },
        { label: t`Time`, of: (x) => whole(x).hours, write: hours, money: false },
        { label: t`Fuel`, of: (x) => whole(x).litres, write: litres, money: false },
      ]
    : [{ label: t`Cost`, of: (x) => costOf(x, prices), write: money }];
  const land: Row[] = [
    { label: t`Overlap`, of: (x) => x.overlap_m2, write: squareMetres, tone: 'overlap', note: s.outside_m2 >= 0.5 ? t`${squareMetres(s.outside_m2)} outside` : undefined },
    { label: t`Uncovered`, of: (x) => x.uncovered_m2, write: squareMetres, tone: 'uncovered' },
    { label: t`Turns`, of: (x) => x.turns, write: count },
    { label: t`Stops`, of: (x) => x.route?.back_outs ?? x.stops, write: count },
  ];
  const directions = [...new Set(s.direction_deg.map(degrees))];
  const alike = (row: Row, summary: PlanSummary | null) => (summary && (row.money === false ? bothWhole(summary, s) : sameMoney(summary, s)) ? summary : null);
  return (
    <section id="numbers" tabIndex={-1} aria-label={t`The plan in numbers`}>
      <Figures label={t`The plan in numbers`}
        list={[
          ...costs.map((row) => figure(row, s, alike(row, before))),
          ...land.map((row) => figure(row, s, before)),
          { label: t`Tracks`, value: count(s.tracks), note: length(s.track_length_m) },
          ...(s.whole_cost ? [{ label: t`Headland`, value: plural(s.headland_passes, 'pass', 'passes'), note: length(s.headland_length_m) }] : []),
        ]} />
      <p class="hint">
        {t`${hectares(s.area_m2)} to work${s.headland_m2 > 0 ? t`: ${hectares(s.headland_m2)} headland, ${hectares(s.body_m2)} behind it` : ''}${directions.length > 0 && directions.length <= 4 ? t`, tracks towards ${directions.join(t` and `)}` : ''}.`}
        {s.outside_m2 >= 0.5 && t` Of the overlap ${squareMetres(s.outside_m2)} lie outside the field.`}
        {typeof s.gap === 'number' && s.gap < TELLING && t` No plan can be cheaper by more than ${percent(s.gap)}.`}
      </p>
      {s.whole_cost && <CostParts cost={s.whole_cost} />}
      <HeadlandDepths sides={plan.headland_sides} />
      <OneDirection plan={plan} />
      <Remarks plan={plan} />
    </section>
  );
}

function Remarks({ plan }: { plan: PlanFull }) {
  const { warnings = [], dropped = [] } = plan.summary;
  if (warnings.length + dropped.length === 0) return null;
  return (
    <Expander title={t`Remarks (${warnings.length + (dropped.length > 0 ? 1 : 0)})`}>
      <ul class="plain">
        {warnings.map((warning, i) => <li key={i}>{sentence(told(warning))}</li>)}
        {dropped.length > 0 && <li>{dropped.length === 1 ? t`One piece was too short to be worth driving; its land counts as uncovered.` : t`${count(dropped.length)} pieces were too short to be worth driving; their land counts as uncovered.`}</li>}
      </ul>
    </Expander>
  );
}
