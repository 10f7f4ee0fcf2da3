// Whether the whole route is planned, in which order, and from which gate to which.
import { drawFor } from '../../actions/drawing';
import type { Place } from '../../api/types';
import { Button } from '../../parts/button';
import { Choice, Select } from '../../parts/choice';
import { Switch } from '../../parts/switch';
import { form } from '../../state/plan_form';
import { useStore } from '../../state/store';
import { t } from '../../words';

const ORDERS = [
  { value: 'best', label: t`In the order that takes the least time` },
  { value: 'adjacent', label: t`One beside the other` },
  ...[1, 2, 3, 4].map((skipped) => ({ value: `skip ${skipped + 1}`, label: t`Leaving out ${skipped}` })),
];

export function RouteForm() {
  const { by, route, order, headland_time, headlands, start, end } = useStore(form, (value) => value);
  const whole = by === 'whole';
  return (
    <section aria-labelledby="route-form-title">
      <h2 id="route-form-title">{t`Route`}</h2>
      {!whole && <Switch on={route} label={t`Plan every metre, from the first to the last`} change={(on) => form.set({ route: on })} />}
      {(whole || route) && (
        <>
          <Select label={t`Tracks are driven`} value={order} options={ORDERS} change={(value) => form.set({ order: value })} />
          {(headlands === 'auto' || headlands > 0) && (
            <Choice label={t`Headland passes come`} value={headland_time} change={(value) => form.set({ headland_time: value })}
              options={[{ value: 'last', label: t`Last` }, { value: 'first', label: t`First` }]} />
          )}
          <Gate end="start" at={start} set={(place) => form.set({ start: place })} />
          <Gate end="end" at={end} set={(place) => form.set({ end: place })} />
        </>
      )}
    </section>
  );
}

const GATES = {
  start: { set: t`Set the start on the map`, move: t`Move the start`, remove: t`Remove the start` },
  end: { set: t`Set the end on the map`, move: t`Move the end`, remove: t`Remove the end` },
};

function Gate({ end, at, set }: { end: 'start' | 'end'; at: Place | null; set: (place: Place | null) => void }) {
  return (
    <div class="row">
      <Button onClick={() => drawFor('gate', async (geometry) => set(geometry.coordinates as Place))}>
        {GATES[end][at ? 'move' : 'set']}
      </Button>
      {at && <Button kind="quiet" onClick={() => set(null)}>{GATES[end].remove}</Button>}
    </div>
  );
}
