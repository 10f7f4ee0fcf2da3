// What was missed, the largest first.
import { useState } from 'preact/hooks';
import { attempt } from '../../actions/notices';
import { planTheGaps } from '../../actions/repair';
import { stopReplay } from '../../actions/play/replay';
import type { DriveFull } from '../../api/types';
import { metres, squareMetres } from '../../format';
import { engine } from '../../map/engine_loader';
import { Button } from '../../parts/button';
import { Expander } from '../../parts/expander';
import { NumberField } from '../../parts/number_field';
import { form } from '../../state/plan_form';
import { review } from '../../state/review';
import { useStore } from '../../state/store';
import { t } from '../../words';

const FEW = 8;

export function Gaps({ drive }: { drive: DriveFull }) {
  const [all, setAll] = useState(false);
  const chosen = useStore(review, (value) => value.gap?.number);
  const list = [...drive.gaps].sort((a, b) => b.area_m2 - a.area_m2);
  return (
    <>
      <h3>{t`Gaps, the largest first`}</h3>
      <ol class="gaps">
        {(all ? list : list.slice(0, FEW)).map((gap) => (
          <li key={gap.number}>
            <button type="button" class="card" aria-current={gap.number === chosen}
              onClick={() => {
                stopReplay();
                review.set({ gap });
                engine()?.look([gap.lon, gap.lat], Math.max(gap.widest_m * 4, Math.sqrt(gap.area_m2) * 2));
              }}>
              <span class="gap-number">{gap.number}</span>
              <span class="grow"><strong>{squareMetres(gap.area_m2)}</strong><span class="sub">{t`at most ${metres(gap.widest_m)} wide`}</span></span>
            </button>
          </li>
        ))}
      </ol>
      {list.length > FEW && <Button kind="quiet" onClick={() => setAll(!all)}>{all ? t`Show the largest only` : t`Show all ${list.length}`}</Button>}
      <PlanGaps />
    </>
  );
}

function PlanGaps() {
  const machine = useStore(form, (value) => value.machine);
  const [least, setLeast] = useState(10);
  const set = (change: Partial<typeof machine>) => form.set({ machine: { ...form.get().machine, ...change } });
  return (
    <>
      <Expander title={t`Machine and smallest gap`}>
        <div class="two">
          <NumberField label={t`Working width`} unit="m" value={machine.width_m} least={0.2} most={100} change={(v) => v !== null && set({ width_m: v })} />
          <NumberField label={t`Turning radius`} unit="m" value={machine.radius_m} least={0} most={100} change={(v) => v !== null && set({ radius_m: v })} />
        </div>
        <NumberField label={t`Ignore gaps smaller than`} unit="m²" value={least} least={0} most={100000} change={(v) => v !== null && setLeast(v)} />
      </Expander>
      <Button kind="main" onClick={() => void attempt(() => planTheGaps(least))}>{t`Plan the gaps`}</Button>
    </>
  );
}
