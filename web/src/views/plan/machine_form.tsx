import { useState } from 'preact/hooks';
import { api } from '../../api/client';
import { width } from '../../format';
import { Button } from '../../parts/button';
import { Select } from '../../parts/choice';
import { More } from '../../parts/more';
import { NumberField } from '../../parts/number_field';
import { attempt, note } from '../../state/notices';
import { form } from '../../state/plan_form';
import { loadMachines, plans } from '../../state/plans';
import { useStore } from '../../state/store';

export function MachineForm() {
  const machine = useStore(form, (value) => value.machine);
  const machines = useStore(plans, (value) => value.machines);
  const set = (change: Partial<typeof machine>) => {
    const { name: _, id: __, ...rest } = machine;
    form.set({ machine: { ...rest, ...change } });
  };
  return (
    <section aria-labelledby="machine-title">
      <h2 id="machine-title">Machine</h2>
      {machines.length > 0 && (
        <Select label="Stored machine" value={machine.id ?? ''}
          options={[
            { value: '', label: 'as typed below' },
            ...machines.map((one) => ({ value: one.id ?? '', label: `${one.name ?? 'Machine'}, ${width(one.width_m)}` })),
          ]}
          change={(id) => {
            const chosen = machines.find((one) => one.id === id);
            if (chosen) form.set({ machine: chosen });
          }} />
      )}
      <div class="two">
        <NumberField label="Working width" unit="m" value={machine.width_m} least={0.2} most={100} change={(v) => v !== null && set({ width_m: v })} />
        <NumberField label="Turning radius" unit="m" value={machine.radius_m} least={0} most={100} change={(v) => v !== null && set({ radius_m: v })} />
      </div>
      <More title="More about the machine">
        <NumberField label="Shortest piece worth driving" unit="m" value={machine.min_length_m ?? null} least={0} most={1000} optional
          hint="Left empty: twice the working width." change={(v) => set({ min_length_m: v })} />
        <SaveMachine />
      </More>
    </section>
  );
}

function SaveMachine() {
  const [name, setName] = useState('');
  const save = async () => {
    const { width_m, radius_m, min_length_m } = form.get().machine;
    const stored = await api.storeMachine({ name: name.trim(), width_m, radius_m, ...(min_length_m ? { min_length_m } : {}) });
    await loadMachines();
    form.set({ machine: stored });
    note(`${name.trim()} is stored. Choose it for other fields, too.`);
    setName('');
  };
  return (
    <div class="row">
      <label class="grow">
        <span class="label">Store this machine under a name</span>
        <input type="text" maxLength={60} value={name} onInput={(event) => setName(event.currentTarget.value)} />
      </label>
      <Button disabled={name.trim() === ''} onClick={() => void attempt(save)}>Store</Button>
    </div>
  );
}
