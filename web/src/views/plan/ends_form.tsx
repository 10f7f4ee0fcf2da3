import type { EndRule } from '../../api/types';
import { Choice, Select } from '../../parts/choice';
import { Expander } from '../../parts/expander';
import { NumberField } from '../../parts/number_field';
import { form, type Passes } from '../../state/plan_form';
import { useStore } from '../../state/store';

const RULES: { value: EndRule; label: string }[] = [
  { value: 'cheapest', label: 'Where it costs least' },
  { value: 'cover', label: 'Cover everything' },
  { value: 'inside', label: 'Stay inside the field' },
  { value: 'centre', label: 'Where the centre line meets the edge' },
];

export function EndsForm() {
  const value = useStore(form, (v) => v);
  const whole = value.by === 'whole';
  return (
    <section aria-labelledby="ends-title">
      <h2 id="ends-title">Ends and edges</h2>
      <Select label="Swaths end at a slanting edge" value={value.end_rule} options={RULES} change={(end_rule) => form.set({ end_rule })} />
      <div class="two">
        <PassesField label="Headland passes" value={value.headlands} whole={whole} change={(headlands) => form.set({ headlands })} />
        <PassesField label="Passes round obstacles" value={value.obstacle_headlands} whole={whole} change={(obstacle_headlands) => form.set({ obstacle_headlands })} />
      </div>
      {whole && <p class="hint">Left empty: as many as turns need, and where they need them.</p>}
      <Expander title="Obstacles and the boundary">
        <Choice label="Tracks at obstacles" value={value.avoid} change={(avoid) => form.set({ avoid })}
          options={[{ value: 'cheapest', label: 'Go round where it pays' }, { value: 'cut', label: 'Always stop' }]} />
        <NumberField label="Distance from obstacles" unit="m" value={value.clearance_m} least={0} most={50} change={(v) => v !== null && form.set({ clearance_m: v })} />
        <Choice label="Can the machine leave the field to turn?" value={value.boundary} change={(boundary) => form.set({ boundary })}
          options={[{ value: 'soft', label: 'Yes' }, { value: 'hard', label: 'No, there is a fence' }]} />
      </Expander>
    </section>
  );
}

/** Of plans of the whole job the number may be left to turns. */
function PassesField({ label, value, whole, change }: { label: string; value: Passes; whole: boolean; change: (passes: Passes) => void }) {
  return (
    <NumberField label={label} unit="" whole value={value === 'auto' ? null : value} least={0} most={20} optional={whole} placeholder={whole ? 'as needed' : ''}
      change={(v) => (v !== null || whole) && change(v ?? 'auto')} />
  );
}
