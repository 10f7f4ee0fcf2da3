// Whether the whole route is planned, in which order, and from which gate to which.
import { drawFor } from '../../actions/drawing';
import type { Place } from '../../api/types';
import { Button } from '../../parts/button';
import { Choice, Select } from '../../parts/choice';
import { Switch } from '../../parts/switch';
import { form } from '../../state/plan_form';
import { useStore } from '../../state/store';

const ORDERS = [
  { value: 'best', label: 'In the order that takes the least time' },
  { value: 'adjacent', label: 'One beside the other' },
  ...[1, 2, 3, 4].map((skipped) => ({ value: `skip ${skipped + 1}`, label: `Leaving out ${skipped}` })),
];

export function RouteForm() {
  const { by, route, order, headland_time, headlands, start, end } = useStore(form, (value) => value);
  const whole = by === 'whole';
  return (
    <section aria-labelledby="route-form-title">
      <h2 id="route-form-title">Route</h2>
      {!whole && <Switch on={route} label="Plan every metre, from the first to the last" change={(on) => form.set({ route: on })} />}
      {(whole || route) && (
        <>
          <Select label="Tracks are driven" value={order} options={ORDERS} change={(value) => form.set({ order: value })} />
          {(headlands === 'auto' || headlands > 0) && (
            <Choice label="Headland passes come" value={headland_time} change={(value) => form.set({ headland_time: value })}
              options={[{ value: 'last', label: 'Last' }, { value: 'first', label: 'First' }]} />
          )}
          <Gate name="start" at={start} set={(place) => form.set({ start: place })} />
          <Gate name="end" at={end} set={(place) => form.set({ end: place })} />
        </>
      )}
    </section>
  );
}

function Gate({ name, at, set }: { name: 'start' | 'end'; at: Place | null; set: (place: Place | null) => void }) {
  return (
    <div class="row">
      <Button onClick={() => drawFor('gate', async (geometry) => set(geometry.coordinates as Place))}>
        {at ? `Move the ${name}` : `Set the ${name} on the map`}
      </Button>
      {at && <Button kind="quiet" onClick={() => set(null)}>{`Remove the ${name}`}</Button>}
    </div>
  );
}
