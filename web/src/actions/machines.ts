// Machines that are stored under a name.
import { api } from '../api/client';
import type { Machine } from '../api/types';
import { form } from '../state/plan_form';
import { plans } from '../state/plans';

export async function loadMachines(): Promise<void> {
  plans.set({ machines: await api.machines() });
}

/** What a machine of the form is stored as. */
const named = (name: string, { width_m, radius_m, min_length_m, turning, rates }: Machine): Machine => ({
  name, width_m, radius_m, ...(typeof min_length_m === 'number' ? { min_length_m } : {}), ...(turning ? { turning } : {}), ...(rates ? { rates } : {}),
});

/** Stores the machine of the form; where `id` is given, it takes the place of that one. */
export async function storeMachine(name: string, id?: string): Promise<void> {
  const machine = named(name, form.get().machine);
  const stored = await (id ? api.changeMachine(id, machine) : api.storeMachine(machine));
  await loadMachines();
  form.set({ machine: stored });
}

export async function deleteMachine(id: string): Promise<void> {
  await api.deleteMachine(id);
  const { id: _, name: __, ...rest } = form.get().machine;
  form.set({ machine: rest });
  await loadMachines();
}
