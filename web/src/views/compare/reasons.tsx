// Why the plan on the map won: what its cost is made of, and what the next best would cost more.
import type { ComparedRoute, Explain, PlanFull, RunnerUp } from '../../api/types';
import { degrees, hours, money, plural, squareMetres } from '../../format';

const REASONS: Record<string, string> = {
  overlap: 'more overlap', uncovered: 'more uncovered land', turns: 'more turns', stops: 'more stops',
};
const CAUSES: Record<string, string> = {
  'row ends': 'Ends of swaths at slanting edges', sides: 'Along the sides', seams: 'Between subfields', detours: 'Detours round obstacles',
  stops: 'Stops at obstacles', 'short pieces': 'Pieces too short to drive', 'given up': 'Left out on purpose', turns: 'Turns',
};

export function Reasons({ plan }: { plan: PlanFull }) {
  return (
    <section aria-labelledby="why-title">
      <h2 id="why-title">Why the plan on the map won</h2>
      {plan.explain ? <Told explain={plan.explain} /> : <p class="hint">This plan was stored without its reasons. Make it again under Plan to see them.</p>}
    </section>
  );
}

function Told({ explain }: { explain: Explain }) {
  const causes = (explain.causes ?? []).filter((cause) => cause.cost > 0).sort((a, b) => b.cost - a.cost);
  const most = Math.max(...causes.map((cause) => cause.cost), 1e-9);
  return (
    <>
      {explain.routes && <Routes routes={explain.routes} />}
      {causes.length > 0 && <h3>What its cost is made of</h3>}
      <ul class="bars">
        {causes.map((cause) => (
          <li key={cause.cause}>
            <div class="between"><span>{CAUSES[cause.cause] ?? cause.cause}</span><span class="number">{money(cause.cost)}</span></div>
            <span class="bar" style={{ width: `${((100 * cause.cost) / most).toFixed(1)}%` }} />
            <span class="sub">{[
              cause.overlap_m2 > 0.5 && `${squareMetres(cause.overlap_m2)} overlap`,
              cause.uncovered_m2 > 0.5 && `${squareMetres(cause.uncovered_m2)} uncovered`,
              cause.count !== null && plural(cause.count, 'time'),
            ].filter(Boolean).join(', ')}</span>
          </li>
        ))}
      </ul>
      {!explain.routes && <h3>The next best plans</h3>}
      {!explain.routes && ((explain.runner_ups ?? []).length === 0 ? <p class="hint">No plan of another kind was considered.</p> : (
        <ul class="plain">{(explain.runner_ups ?? []).map((other, i) => <li key={i}>{sentence_of(other)}</li>)}</ul>
      ))}
    </>
  );
}

function sentence_of(other: RunnerUp): string {
  const towards = other.direction_deg.slice(0, 3).map(degrees).join(', ');
  const how = other.subfields > 1 ? `${other.subfields} subfields, towards ${towards}` : `Tracks towards ${towards}`;
  const saved = Object.entries(other.more_by).filter(([, more]) => more < -0.005).map(([what]) => (what === 'uncovered' ? 'uncovered land' : what));
  return `${how}: ${money(other.more)} more expensive, mostly because of ${REASONS[other.main_reason] ?? other.main_reason}${saved.length > 0 ? `, although it saves ${saved.join(' and ')}` : ''}.`;
}

/** Plans whose whole routes were compared: the one on the map first. */
function Routes({ routes }: { routes: ComparedRoute[] }) {
  return (
    <>
      <h3>Whole routes that were compared</h3>
      <table class="differences">
        <thead><tr><th>Tracks and headlands</th><th>Cost</th><th>Time</th></tr></thead>
        <tbody>
          {routes.map((route, i) => (
            <tr key={i} class={i === 0 ? 'total' : ''}>
              <th scope="row">
                {towards(route)}
                <span class="sub">{passes(route)}{route.without_room > 0 && `; ${plural(route.without_room, 'leg')} without room`}</span>
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
  if (directions_deg.length === 0) return 'Headland passes alone';
  const shown = directions_deg.slice(0, 3).map(degrees).join(', ');
  return `Towards ${shown}${directions_deg.length > 3 ? ' …' : ''}`;
}
const passes = ({ headlands, all_round, kind }: ComparedRoute) =>
  `${headlands === 0 ? 'no headland' : `${plural(headlands, 'pass', 'passes')} ${all_round ? 'all round' : 'where tracks end'}`}${kind === 'adjacent order' ? ', one track beside the other' : ''}`;
