// The example farm, and the tour.
import { api } from '../api/client';
import { ApiError } from '../api/errors';
import { STOPS, tour } from '../state/tour';
import { storeAll } from './fields';
import { show } from './session';
import { busy } from './files/upload';
import { t } from '../words';

/** Stores the fields drawn for the project as if their file had been chosen, and opens the first. */
export async function openExampleFarm(): Promise<void> {
  await busy(t`Opening the example farm …`, async () => {
    const response = await fetch('/example-farm.json');
    if (!response.ok) throw new ApiError('failed', t`The example farm could not be read. Reload the page, then try again.`, response.status);
    const upload = await api.upload(new File([await response.blob()], 'example-farm.geojson'));
    await storeAll(upload);
  });
}

export function goToStop(stop: number | null): void {
  tour.set({ stop });
  const at = stop === null ? null : STOPS[stop];
  if (at) show(at.view);
}
