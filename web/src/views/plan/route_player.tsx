// The route driven on the map, with what it has taken so far.
import { leaveRoute, pauseRoute, playRoute, seekRoute } from '../../actions/play/route_play';
import type { LegKind, PlanFull } from '../../api/types';
import { clock, count, litres, money } from '../../format';
import { Button } from '../../parts/button';
import { Select } from '../../parts/choice';
import { Figures } from '../../parts/figures';
import { Icon } from '../../parts/icon';
import { Slider } from '../../parts/slider';
import { routePlay, soFar } from '../../state/route_play';
import { useStore } from '../../state/store';
import { t } from '../../words';

const SPEEDS = [1, 5, 20, 60, 200, 600];
const DOES: Record<LegKind, string> = { work: t`a track`, headland: t`a headland pass`, turn: t`a turn`, transit: t`a way with the work off`, back_out: t`backing out` };

export function RoutePlayer({ plan }: { plan: PlanFull }) {
  const state = useStore(routePlay, (value) => value);
  const route = plan.summary.route!;
  const mine = state.plan === plan.id;
  const at = mine ? state.at_s : 0;
  const playing = mine && state.playing;
  const { leg, litres: fuel, euros } = soFar(plan, at);
  const now = route.legs[leg];
  return (
    <div class="replay" role="group" aria-label={t`Drive the route`}>
      <div class="row tight">
        <Button aria-label={playing ? t`Pause the route` : t`Drive the route`} onClick={() => (playing ? pauseRoute() : playRoute(plan.id, route))}>
          <Icon name={playing ? 'pause' : 'play'} /> {playing ? t`Pause` : t`Drive`}
        </Button>
        <Select label={t`Speed`} value={String(state.speed)} change={(value) => routePlay.set({ speed: Number(value) })}
          options={SPEEDS.map((speed) => ({ value: String(speed), label: `${speed} ×` }))} />
        {mine && <Button onClick={leaveRoute}>{t`Whole route`}</Button>}
      </div>
      <Slider label={t`Time`} value={at} least={0} most={Math.max(1, route.time_s)} step="any" says={t`${clock(at)} of ${clock(route.time_s)} h`}
        change={(value) => seekRoute(plan.id, value)} />
      {mine && now && <p class="hint">{t`Leg ${count(leg + 1)} of ${count(route.legs.length)}: ${DOES[now.kind]}.`}</p>}
      {mine && now && (
        <Figures label={t`So far`}
          list={[
            { label: t`Hours`, value: clock(at) },
            ...(plan.summary.whole_cost ? [{ label: t`Fuel so far`, value: litres(fuel) }, { label: t`Machine and fuel`, value: money(euros) }] : []),
          ]} />
      )}
    </div>
  );
}
