import { useState } from 'preact/hooks';
import { deleteMachine, storeMachine } from '../../actions/machines';
import { attempt, note } from '../../actions/notices';
import type { Machine } from '../../api/types';
import { width } from '../../format';
import { measures } from '../../measures';
import { Button } from '../../parts/button';
import { Select } from '../../parts/choice';
import { ConfirmButton } from '../../parts/confirm_button';
import { Expander } from '../../parts/expander';
import { Icon } from '../../parts/icon';
import { NumberField } from '../../parts/number_field';
import { TitleField } from '../../parts/title_field';
import { form } from '../../state/plan_form';
import { PRESETS, presetOf, presetsFor } from '../../state/presets';
import { plans } from '../../state/plans';
import { useStore } from '../../state/store';
import { t } from '../../words';

export function MachineForm() {
  const machine = useStore(form, (value) => value.machine);
  const machines = useStore(plans, (value) => value.machines);
  const system = useStore(measures, (value) => value.system);
  const set = (change: Partial<typeof machine>) => {
    const { name: _, id: __, ...rest } = form.get().machine;
    form.set({ machine: { ...rest, ...change } });
  };
  return (
    <section aria-labelledby="machine-title">
      <h2 id="machine-title">{t`Machine`}</h2>
      {machines.length > 0 && (
        <Select label={t`Stored machine`} value={machines.some((one) => one.id === machine.id) ? (machine.id ?? '') : ''}
          options={[
            { value: '', label: t`as typed below` },
            ...machines.map((one) => ({ value: one.id ?? '', label: `${one.name ?? t`Machine`}, ${width(one.width_m)}` })),
          ]}
          change={(id) => {
            const chosen = machines.find((one) => one.id === id);
            if (chosen) form.set({ machine: chosen });
          }} />
      )}
      <Select label={t`Usual machines`} value={presetOf(machine)?.key ?? ''}
        options={[{ value: '', label: t`none of them: as typed below` }, ...presetsFor(system).map(({ key, label }) => ({ value: key, label }))]}
        change={(key) => {
          const preset = PRESETS.find((one) => one.key === key);
          if (preset) form.set({ machine: { ...preset.machine } });
        }} />
      <div class="two">
        <NumberField label={t`Working width`} unit="m" value={machine.width_m} least={0.2} most={100} change={(v) => v !== null && set({ width_m: v })} />
        <NumberField label={t`Turning radius`} unit="m" value={machine.radius_m} least={0} most={100} change={(v) => v !== null && set({ radius_m: v })} />
      </div>
      <Expander title={t`More about the machine`}>
        <NumberField label={t`Shortest piece worth driving`} unit="m" value={machine.min_length_m ?? null} least={0} most={1000} optional
          hint={t`If left empty: twice the working width.`} change={(v) => set({ min_length_m: v })} />
        <ChosenMachine machine={machine} />
        <SaveMachine />
      </Expander>
    </section>
  );
}

/** The machine at hand under a name; one that has the name already is replaced. */
function SaveMachine() {
  const [name, setName] = useState('');
  const machines = useStore(plans, (value) => value.machines);
  const same = machines.find((one) => one.name === name.trim());
  const save = async () => {
    await storeMachine(name.trim(), same?.id);
    note(same ? t`${name.trim()} is changed. You can choose it for other fields, too.` : t`${name.trim()} is stored. You can choose it for other fields, too.`);
    setName('');
  };
  return (
    <div class="row">
      <label class="grow">
        <span class="label">{t`Store this machine under a name`}</span>
        <input type="text" maxLength={60} value={name} onInput={(event) => setName(event.currentTarget.value)}
          onKeyDown={(event) => { if (event.key === 'Enter') { event.preventDefault(); if (name.trim() !== '') void attempt(save); } }} />
      </label>
      <Button disabled={name.trim() === ''} onClick={() => void attempt(save)}>{same ? t`Replace` : t`Store`}</Button>
    </div>
  );
}

/** Another name for the stored machine that is chosen, or its end. */
function ChosenMachine({ machine }: { machine: Machine }) {
  const id = machine.id;
  if (!id) return null;
  const remove = async () => {
    await deleteMachine(id);
    note(t`${machine.name ?? t`The machine`} is deleted. Its width and radius stay in the form.`);
  };
  return (
    <div class="row tight">
      <TitleField key={id} label={t`Name of the stored machine`} value={machine.name ?? ''} save={(name) => void attempt(() => storeMachine(name, id))} />
      <ConfirmButton label={t`Delete the machine ${machine.name ?? ''}`} ask={t`Delete it`} act={() => void attempt(remove)}><Icon name="bin" /></ConfirmButton>
    </div>
  );
}
