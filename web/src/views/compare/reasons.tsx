// Why the plan on the map won: what its cost is made of, and what the next best would cost more.
import type { ComparedRoute, Explain, PlanFull, PlanItem, RunnerUp } from '../../api/types';
import { change, degrees, hours, money, plural, squareMetres, width } from '../../format';
import { costOf, form, pricesOf } from '../../state/plan_form';
import { plans } from '../../state/plans';
import { useStore } from '../../state/store';
import { CostParts } from '../plan/figures/cost_parts';
import { t } from '../../words';

const REASONS: Record<string, string> = {
  overlap: t`more overlap`, uncovered: t`more uncovered land`, turns: t`more turns`, stops: t`more stops`,
};
const SAVES: Record<string, string> = { overlap: t`overlap`, uncovered: t`uncovered land`, turns: t`turns`, stops: t`stops` };
const CAUSES: Record<string, string> = {
  'row ends': t`Ends of swaths at slanting edges`, sides: t`Along the sides`, seams: t`Between subfields`, detours: t`Detours round obstacles`,
  stops: t`Stops at obstacles`, 'short pieces': t`Pieces too short to drive`, 'given up': t`Left out on purpose`, turns: t`Turns`,
};

export function Reasons({ plan }: { plan: PlanFull }) {
  return (
    <section aria-labelledby="why-title">
      <h2 id="why-title">{t`Why the plan on the map won`}</h2>
      {(!plan.explain || plan.asked?.settings?.line) && <p>{withoutSearch(plan)}</p>}
      {plan.explain && <Told explain={plan.explain} />}
      {!plan.explain?.causes?.length && (plan.summary.whole_cost ? <CostParts cost={plan.summary.whole_cost} /> : <TrackParts plan={plan} />)}
      {!plan.explain && <Stored plan={plan} />}
    </section>
  );
}

/** Why nothing was searched for. */
function withoutSearch({ asked, kind, summary }: PlanFull): string {
  if (kind === 'repair') return t`It works what a drive has missed: its lines follow the gaps.`;
  if (asked?.settings?.line) return t`Its tracks follow the line that you chose, so that no other direction was searched.`;
  if (summary.kind !== 'straight') return t`Its tracks follow the edge along which they cost least.`;
  return t`It was chosen among the plans worth a choice, or stored without its reasons.`;
}

/** What the cost of tracks is made of, at the prices of the form. */
function TrackParts({ plan: { summary } }: { plan: PlanFull }) {
  const prices = pricesOf(useStore(form, (value) => value));
  const parts = [
    { label: t`Overlap`, of: prices.overlap * summary.overlap_m2, said: squareMetres(summary.overlap_m2) },
    { label: t`Uncovered land`, of: prices.uncovered * summary.uncovered_m2, said: squareMetres(summary.uncovered_m2) },
    { label: t`Turns`, of: prices.turn * summary.turns, said: plural(summary.turns, 'turn') },
    { label: t`Stops`, of: prices.stop * summary.stops, said: plural(summary.stops, 'stop') },
  ].filter(({ of }) => of > 0.005);
  const most = Math.max(...parts.map(({ of }) => of), 1e-9);
  return (
    <>
      <h3>{t`What its cost is made of`}</h3>
      <ul class="bars">
        {parts.map(({ label, of, said }) => (
          <li key={label}>
            <div class="between"><span>{label}</span><span class="number">{money(of)}</span></div>
            <span class="bar" style={{ width: `${((100 * of) / most).toFixed(1)}%` }} />
            <span class="sub">{said}</span>
          </li>
        ))}
      </ul>
    </>
  );
}

/** Other plans of the field of the same kind, from the cheapest. */
function Stored({ plan }: { plan: PlanFull }) {
  const list = useStore(plans, (value) => value.list);
  const whole = plan.summary.whole_cost;
  const price = (item: PlanItem) => (whole ? (item.route?.euros ?? null) : item.route ? null : costOf(item));
  const own = whole ? whole.euros : costOf(plan.summary);
  const others = list.filter((item) => item.id !== plan.id && price(item) !== null).sort((a, b) => price(a)! - price(b)!).slice(0, 5);
  if (others.length === 0) return null;
  return (
    <>
      <h3>{t`Other plans of this field`}</h3>
      <ul class="plain">
        {others.map((item) => (
          <li key={item.id}>{t`${item.name}, ${width(item.width_m)} wide: ${money(price(item))}, ${change(price(item)! - own, money)} to the plan on the map.`}</li>
        ))}
      </ul>
    </>
  );
}

function Told({ explain }: { explain: Explain }) {
  const causes = (explain.causes ?? []).filter((cause) => cause.cost > 0).sort((a, b) => b.cost - a.cost);
  const most = Math.max(...causes.map((cause) => cause.cost), 1e-9);
  return (
    <>
      {explain.routes && <Routes routes={explain.routes} />}
      {causes.length > 0 && <h3>{t`What its cost is made of`}</h3>}
      <ul class="bars">
        {causes.map((cause) => (
          <li key={cause.cause}>
            <div class="between"><span>{CAUSES[cause.cause] ?? cause.cause}</span><span class="number">{money(cause.cost)}</span></div>
            <span class="bar" style={{ width: `${((100 * cause.cost) / most).toFixed(1)}%` }} />
            <span class="sub">{[
              cause.overlap_m2 > 0.5 && t`${squareMetres(cause.overlap_m2)} overlap`,
              cause.uncovered_m2 > 0.5 && t`${squareMetres(cause.uncovered_m2)} uncovered`,
              cause.count !== null && plural(cause.count, 'time'),
            ].filter(Boolean).join(', ')}</span>
          </li>
        ))}
      </ul>
      {!explain.routes && <h3>{t`The next best plans`}</h3>}
      {!explain.routes && ((explain.runner_ups ?? []).length === 0 ? <p class="hint">{t`No other plan was considered.`}</p> : (
        <ul class="plain">{(explain.runner_ups ?? []).map((other, i) => <li key={i}>{sentence_of(other)}</li>)}</ul>
      ))}
    </>
  );
}

function sentence_of(other: RunnerUp): string {
  const towards = other.direction_deg.slice(0, 3).map(degrees).join(', ');
  const how = other.subfields > 1 ? t`${other.subfields} subfields, towards ${towards}` : t`Tracks towards ${towards}`;
  const saved = Object.entries(other.more_by).filter(([, more]) => more < -0.005).map(([what]) => SAVES[what] ?? what);
  return t`${how}: ${money(other.more)} more expensive, mostly because of ${REASONS[other.main_reason] ?? other.main_reason}${saved.length > 0 ? t`, although it saves ${saved.join(t` and `)}` : ''}.`;
}

/** Plans whose whole routes were compared: the one on the map first. */
function Routes({ routes }: { routes: ComparedRoute[] }) {
  return (
    <>
      <h3>{t`Whole routes that were compared`}</h3>
      <table class="differences">
        <thead><tr><th>{t`Tracks and headlands`}</th><th>{t`Cost`}</th><th>{t`Time`}</th></tr></thead>
        <tbody>
          {routes.map((route, i) => (
            <tr key={i} class={i === 0 ? 'total' : ''}>
              <th scope="row">
                {towards(route)}
                <span class="sub">{passes(route)}{route.dropped > 0 && t`; without ${plural(route.dropped, 'piece')}`}{route.without_room > 0 && t`; ${plural(route.without_room, 'leg')} without room`}</span>
              </th>
              <td>{money(route.euros)}</td>
              <td>{hours(route.hours)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}

function towards({ directions_deg }: ComparedRoute): string {
  if (directions_deg.length === 0) return t`Headland passes alone`;
  const shown = directions_deg.slice(0, 3).map(degrees).join(', ');
  return t`Towards ${shown}${directions_deg.length > 3 ? ' …' : ''}`;
}
const passes = ({ headlands, all_round, kind }: ComparedRoute) =>
  `${headlands === 0 ? t`no headland` : all_round ? t`${plural(headlands, 'pass', 'passes')} all round` : t`${plural(headlands, 'pass', 'passes')} where tracks end`}${kind === 'adjacent order' ? t`, one track beside the other` : ''}${kind === 'corners worked out' ? t`, corners worked out` : ''}`;
