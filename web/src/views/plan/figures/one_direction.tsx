// Beside a divided plan: what one direction over the whole field would cost, and a way to take it.
import { attempt } from '../../../actions/notices';
import { planAlong } from '../../../actions/planning';
import type { PlanFull, Place } from '../../../api/types';
import { degrees, hours, money } from '../../../format';
import { moved } from '../../../metres';
import { Button } from '../../../parts/button';
import { costOf, form } from '../../../state/plan_form';
import { useStore } from '../../../state/store';
import { t } from '../../../words';

interface Undivided {
  direction_deg: number;
  /** What it costs more; less than 0 where it costs less. */
  more: number;
  said: string;
}

function undividedOf({ explain, summary }: PlanFull): Undivided | null {
  const route = explain?.routes?.find(({ directions_deg, kind }) => directions_deg.length === 1 && kind !== 'no headland');
  if (route && summary.whole_cost)
    return { direction_deg: route.directions_deg[0]!, more: route.euros - summary.whole_cost.euros, said: t`${money(route.euros)} and ${hours(route.hours)}` };
  const other = explain?.runner_ups?.find(({ subfields }) => subfields === 1);
  if (!other) return null;
  return { direction_deg: other.direction_deg[0]!, more: costOf(other) - costOf(summary), said: money(costOf(other)) };
}

const HALF_M = 200;
/** A line of this bearing through the middle of the field: what tracks are parallel to. */
function lineAlong({ bbox: [west, south, east, north] }: PlanFull, deg: number): [Place, Place] {
  const middle: Place = [(west + east) / 2, (south + north) / 2];
  const [x, y] = [HALF_M * Math.sin((deg * Math.PI) / 180), HALF_M * Math.cos((deg * Math.PI) / 180)];
  return [moved(middle, -x, -y), moved(middle, x, y)];
}

export function OneDirection({ plan }: { plan: PlanFull }) {
  useStore(form, (value) => value); // costs of tracks are counted at its prices
  if (plan.summary.subfields < 2) return null;
  const other = undividedOf(plan);
  if (!other) return null;
  return (
    <div class="between aside" role="group" aria-label={t`One direction`}>
      <p class="hint">
        {other.more < 0
          ? t`With one direction over the whole field, towards ${degrees(other.direction_deg)}: ${other.said}, ${money(-other.more)} less.`
          : t`With one direction over the whole field, towards ${degrees(other.direction_deg)}: ${other.said}, ${money(other.more)} more.`}
      </p>
      <Button onClick={() => void attempt(() => planAlong(lineAlong(plan, other.direction_deg)))}>{t`Take one direction`}</Button>
    </div>
  );
}
