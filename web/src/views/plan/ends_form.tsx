import type { EndRule } from '../../api/types';
import { Choice, Select } from '../../parts/choice';
import { Expander } from '../../parts/expander';
import { NumberField } from '../../parts/number_field';
import { form, type Passes } from '../../state/plan_form';
import { useStore } from '../../state/store';
import { t } from '../../words';

const RULES: { value: EndRule; label: string }[] = [
  { value: 'cheapest', label: t`Where it costs least` },
  { value: 'cover', label: t`Cover everything` },
  { value: 'inside', label: t`Stay inside the field` },
  { value: 'centre', label: t`Where the centre line meets the edge` },
];

export function EndsForm() {
  const value = useStore(form, (v) => v);
  const whole = value.by === 'whole';
  return (
    <section aria-labelledby="ends-title">
      <h2 id="ends-title">{t`Ends and edges`}</h2>
      <Select label={t`Swaths end at a slanting edge`} value={value.end_rule} options={RULES} change={(end_rule) => form.set({ end_rule })} />
      <div class="two">
        <PassesField label={t`Headland passes`} value={value.headlands} whole={whole} change={(headlands) => form.set({ headlands })} />
        <PassesField label={t`Passes round obstacles`} value={value.obstacle_headlands} whole={whole} change={(obstacle_headlands) => form.set({ obstacle_headlands })} />
      </div>
      {whole && <p class="hint">{t`Left empty: as many as turns need, and where they need them.`}</p>}
      <Expander title={t`Obstacles and the boundary`}>
        <Choice label={t`Tracks at obstacles`} value={value.avoid} change={(avoid) => form.set({ avoid })}
          options={[{ value: 'cheapest', label: t`Go round where it pays` }, { value: 'cut', label: t`Always stop` }]} />
        <NumberField label={t`Distance from obstacles`} unit="m" value={value.clearance_m} least={0} most={50} change={(v) => v !== null && form.set({ clearance_m: v })} />
        <Choice label={t`Can the machine leave the field to turn?`} value={value.boundary} change={(boundary) => form.set({ boundary })}
          options={[{ value: 'soft', label: t`Yes` }, { value: 'hard', label: t`No, there is a fence` }]} />
      </Expander>
    </section>
  );
}

/** Of plans of the whole job the number may be left to turns. */
function PassesField({ label, value, whole, change }: { label: string; value: Passes; whole: boolean; change: (passes: Passes) => void }) {
  return (
    <NumberField label={label} unit="" whole value={value === 'auto' ? null : value} least={0} most={20} optional={whole} placeholder={whole ? t`as needed` : ''}
      change={(v) => (v !== null || whole) && change(v ?? 'auto')} />
  );
}
