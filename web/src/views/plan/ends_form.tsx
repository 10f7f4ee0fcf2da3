import type { EndRule } from '../../api/types';
import { Choice, Select } from '../../parts/choice';
import { Expander } from '../../parts/expander';
import { NumberField } from '../../parts/number_field';
import { form } from '../../state/plan_form';
import { useStore } from '../../state/store';

const RULES: { value: EndRule; label: string }[] = [
  { value: 'cheapest', label: 'Where it costs least' },
  { value: 'cover', label: 'Cover everything' },
  { value: 'inside', label: 'Stay inside the field' },
  { value: 'centre', label: 'Where the centre line meets the edge' },
];

export function EndsForm() {
  const value = useStore(form, (v) => v);
  return (
    <section aria-labelledby="ends-title">
      <h2 id="ends-title">Ends and edges</h2>
      <Select label="Swaths end at a slanting edge" value={value.end_rule} options={RULES} change={(end_rule) => form.set({ end_rule })} />
      <div class="two">
        <NumberField label="Headland passes" unit="" whole value={value.headlands} least={0} most={20} change={(v) => v !== null && form.set({ headlands: v })} />
        <NumberField label="Passes round obstacles" unit="" whole value={value.obstacle_headlands} least={0} most={20}
          change={(v) => v !== null && form.set({ obstacle_headlands: v })} />
      </div>
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
