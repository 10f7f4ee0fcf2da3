// What is usual for the machine of the form: asked anew when its width changes.
import { api } from '../api/client';
import { form } from '../state/plan_form';
import { usual } from '../state/rates';

async function load(): Promise<void> {
  const { width_m } = form.get().machine;
  if (usual.get().width_m === width_m && usual.get().operations.length > 0) return;
  const operations = await api.operations(width_m);
  if (form.get().machine.width_m === width_m) usual.set({ width_m, operations });
}

export async function loadUsualRates(): Promise<void> {
  await load();
}
/** They are hints: where the server is away or busy, those of before stay. */
export function followWidth(): void {
  form.listen(() => void load().catch(() => {}));
}
