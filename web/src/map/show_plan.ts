import type { FeatureCollection } from '../api/types';
import { isShown, plans } from '../state/plans';
import { session } from '../state/session';
import { NOTHING, type Shown } from './shown';
import { PARTS_OF } from './plan_layers';

/** So many tracks are told apart at a glance; of more, numbers show from nearer. */
const MANY = 800;

/** The open plan on the map, while a view is open that is about plans. */
export function followPlan({ map, fill, visible }: Shown): void {
  const filled: Record<string, FeatureCollection | undefined> = {};
  const sync = () => {
    const { view } = session.get();
    const here = view === 'plan' || view === 'compare';
    const { shapes, open, layers } = plans.get();
    for (const [name, parts] of Object.entries(PARTS_OF)) {
      const on = here && open !== null && isShown(name);
      const data = on ? shapes[name] : undefined;
      if (on && data !== filled[name]) {
        filled[name] = data;
        fill(`plan:${name}`, data ?? NOTHING);
      }
      visible(parts, on && data !== undefined);
    }
    const tracks = layers.find((layer) => layer.name === 'tracks')?.features ?? 0;
    for (const layer of ['plan:tracks-number', 'plan:tracks-arrow']) map.setLayerZoomRange(layer, tracks > MANY ? 17 : 14, 24);
  };
  plans.listen(sync);
  session.listen(sync);
  sync();
}
