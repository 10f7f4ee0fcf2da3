import { useState } from 'preact/hooks';
import { drawFor } from '../../actions/drawing';
import { changeField } from '../../actions/fields';
import { Button } from '../../parts/button';
import { Choice } from '../../parts/choice';
import { Expander } from '../../parts/expander';
import { NumberField } from '../../parts/number_field';
import type { Purpose } from '../../state/drawing';
import { t } from '../../words';

type Form = 'obstacle-point' | 'obstacle-area' | 'obstacle-line';

/** Poles and trees by a click, ponds by their corners, ditches by their line. */
export function AddObstacle() {
  const [form, setForm] = useState<Form>('obstacle-point');
  const [kind, setKind] = useState<'obstacle' | 'passable'>('obstacle');
  const [size_m, setSize] = useState(2);
  const start = () =>
    drawFor(form as Purpose, (geometry) =>
      changeField({ add: [{ kind, geometry, ...(form === 'obstacle-area' ? {} : { size_m }) }] }),
    );
  return (
    <Expander title={t`Add an obstacle`}>
      <Choice label={t`Shape`} value={form} change={setForm}
        options={[
          { value: 'obstacle-point', label: t`Point` },
          { value: 'obstacle-area', label: t`Area` },
          { value: 'obstacle-line', label: t`Line` },
        ]} />
      <Choice label={t`Can the machine cross it?`} value={kind} change={setKind}
        options={[
          { value: 'obstacle', label: t`No` },
          { value: 'passable', label: t`Yes, without working` },
        ]} />
      {form !== 'obstacle-area' && (
        <NumberField label={form === 'obstacle-point' ? t`How wide it is` : t`How wide the line is`} unit="m" value={size_m} least={0.1} most={200}
          change={(value) => value !== null && setSize(value)} />
      )}
      <Button onClick={start}>{t`Place it on the map`}</Button>
    </Expander>
  );
}
