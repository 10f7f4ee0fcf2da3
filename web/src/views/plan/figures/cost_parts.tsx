// What the whole cost is made of, and by which rates it was counted.
import type { WholeCost } from '../../../api/types';
import { money, percent } from '../../../format';
import { Expander } from '../../../parts/expander';
import { OPERATIONS } from '../../../state/rates';
import { t } from '../../../words';

const PARTS: { label: string; of: (cost: WholeCost) => number }[] = [
  { label: t`Machine and driver`, of: (c) => c.euros_hours },
  { label: t`Fuel`, of: (c) => c.euros_fuel },
  { label: t`Overlap`, of: (c) => c.euros_overlap },
  { label: t`Missed land`, of: (c) => c.euros_missed },
  { label: t`Stops`, of: (c) => c.euros_stops },
  { label: t`Crop driven over`, of: (c) => c.euros_driven_over },
  { label: t`Legs without room`, of: (c) => c.euros_without_room },
];

export function CostParts({ cost }: { cost: WholeCost }) {
  const parts = PARTS.filter(({ of }) => of(cost) > 0.005);
  const most = Math.max(...parts.map(({ of }) => of(cost)), 1e-9);
  return (
    <Expander title={t`What the whole cost is made of`}>
      <ul class="bars">
        {parts.map(({ label, of }) => (
          <li key={label}>
            <div class="between"><span>{label}</span><span class="number">{money(of(cost))}</span></div>
            <span class="bar" style={{ width: `${((100 * of(cost)) / most).toFixed(1)}%` }} />
          </li>
        ))}
      </ul>
      <p class="hint">
        {t`${OPERATIONS[cost.rates.operation] ?? cost.rates.operation} at ${money(cost.rates.price_per_hour)} an hour. `}
        {t`The work is off for ${percent(cost.not_working_share)} of the time; field efficiency ${percent(cost.field_efficiency)}.`}
      </p>
    </Expander>
  );
}
