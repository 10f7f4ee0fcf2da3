// All stored fields on one map: a click opens one.
import type { LayerSpecification } from 'maplibre-gl';
import { openField } from '../actions/fields';
import { attempt } from '../actions/notices';
import type { Feature } from '../api/types';
import { drawing } from '../state/drawing';
import { farm } from '../state/farm';
import { fields } from '../state/fields';
import { session } from '../state/session';
import { farmBox } from './boxes';
import { fit } from './camera';
import { collection, type LiveMap } from './live_map';
import type { Colours } from './palette';

export const farmLayers = (c: Colours): LayerSpecification[] => [
  { id: 'farm', type: 'fill', source: 'farm', paint: { 'fill-color': ['case', ['get', 'ticked'], c.Covered, ['get', 'planned'], c.Field, c.Headland] } },
  { id: 'farm-edge', type: 'line', source: 'farm', paint: { 'line-color': c.SubfieldEdge, 'line-width': 1.2 } },
  { id: 'farm-place', type: 'circle', source: 'farm', maxzoom: 12, paint: { 'circle-radius': 4, 'circle-color': c.FieldEdge } },
];

export function followFarm({ map, fill, visible }: LiveMap): void {
  let drawn: unknown[] = [];
  let fitted = false;
  const sync = () => {
    const { list, open, choosing } = fields.get();
    const { ticked } = farm.get();
    visible(['farm', 'farm-edge', 'farm-place'], session.get().view === 'fields' && choosing === null);
    if (drawn[0] === list && drawn[1] === open?.id && drawn[2] === ticked) return;
    drawn = [list, open?.id, ticked];
    const shapes = (list ?? []).filter(({ id, outline }) => id !== open?.id && outline !== undefined);
    fill('farm', collection(shapes.map((field): Feature => ({
      type: 'Feature', geometry: field.outline!, properties: { id: field.id, ticked: ticked.has(field.id), planned: field.last_plan != null },
    }))));
    const box = farmBox(list ?? []);
    if (!fitted && box && !open) {
      fitted = true;
      fit(map, box);
    }
  };
  for (const from of [fields, farm, session]) from.listen(sync);
  sync();
  map.on('click', 'farm', (event) => {
    const id = event.features?.[0]?.properties['id'] as string | undefined;
    if (id && !drawing.get().purpose && session.get().view === 'fields' && fields.get().choosing === null) void attempt(() => openField(id));
  });
}
