// The route in numbers, kind by kind, in the colours of the map.
import type { LegKind, PlanFull, Route } from '../../../api/types';
import { clock, count, length, percent, plural } from '../../../format';
import { DAY, NIGHT, type Colours } from '../../../map/palette';
import { MarkOf, type Mark } from '../../../parts/mark';
import { sumsByKind } from '../../../state/route_sums';
import { isNight, session } from '../../../state/session';
import { useStore } from '../../../state/store';
import { RoutePlayer } from '../route_player';
import { t } from '../../../words';

const KINDS: Record<LegKind, { title: string; colour: keyof Colours & string; form: Mark['form'] }> = {
  work: { title: t`Tracks`, colour: 'Track', form: 'line' },
  headland: { title: t`Headland passes`, colour: 'HeadlandPass', form: 'line' },
  turn: { title: t`Turns`, colour: 'Turn', form: 'line' },
  transit: { title: t`Other ways`, colour: 'Transit', form: 'line' },
  back_out: { title: t`Backing out`, colour: 'BackOut', form: 'dashed' },
};

export function RouteFigures({ plan, route }: { plan: PlanFull; route: Route }) {
  useStore(session, (value) => value.theme);
  const colours = isNight() ? NIGHT : DAY;
  const sums = sumsByKind(route.legs);
  const idle = sums.filter(({ kind }) => kind !== 'work' && kind !== 'headland').reduce((all, { length_m }) => all + length_m, 0);
  return (
    <section aria-labelledby="route-title">
      <h2 id="route-title">{t`The route`}</h2>
      <table class="legs" aria-labelledby="route-title">
        <thead><tr><th>{t`Legs`}</th><th>{t`Count`}</th><th>{t`Length`}</th><th>{t`Time`}</th></tr></thead>
        <tbody>
          {sums.map((sum) => {
            const { title, colour, form } = KINDS[sum.kind];
            return (
              <tr key={sum.kind}>
                <th scope="row"><span class="marked"><MarkOf mark={{ colour: String(colours[colour]), form }} />{title}</span></th>
                <td>{count(sum.legs)}</td>
                <td>{length(sum.length_m)}</td>
                <td>{clock(sum.time_s)}</td>
              </tr>
            );
          })}
          <tr class="total">
            <th scope="row">{t`All`}</th>
            <td>{count(route.legs.length)}</td>
            <td>{length(route.length_m)}</td>
            <td>{clock(route.time_s)}</td>
          </tr>
        </tbody>
      </table>
      <p class="hint">
        {t`On ${percent(route.length_m > 0 ? idle / route.length_m : 0)} of the way the work is off`}
        {route.reverse_m > 0 && t`, and ${length(route.reverse_m)} are driven in reverse`}.
        {t` No route over these tracks and passes can be quicker by more than ${percent(Math.max(0, route.gap))}.`}
      </p>
      <RoutePlayer plan={plan} />
      {route.without_room > 0 && (
        <p class="notice error">{t`${plural(route.without_room, 'leg has', 'legs have')} no room on the land: red on the map.`}</p>
      )}
    </section>
  );
}
