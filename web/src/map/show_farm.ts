// All stored fields on one map: a click opens one.
import type { LayerSpecification } from 'maplibre-gl';
import { openField } from '../actions/fields';
import { attempt } from '../actions/notices';
import type { Feature, FieldItem } from '../api/types';
import { hectares } from '../format';
import { measures } from '../measures';
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
  // From far a field is less than a pixel, and its outline is left out: a dot says where it is.
  { id: 'farm-place', type: 'circle', source: 'farm-places', maxzoom: 12, paint: { 'circle-radius': 4, 'circle-color': c.FieldEdge, 'circle-stroke-color': c.Background, 'circle-stroke-width': 1 } },
  { id: 'farm-name', type: 'symbol', source: 'farm-places', minzoom: 13, layout: { 'icon-image': ['concat', 'name:', ['get', 'label']], 'icon-padding': 2 } },
];
const PARTS = ['farm', 'farm-edge', 'farm-place', 'farm-name'];

const LONGEST = 24;
const label = ({ name, area_m2 }: FieldItem) => `${name.length > LONGEST ? `${name.slice(0, LONGEST - 1)}…` : name} · ${hectares(area_m2)}`;
const middle = ({ bbox: [w, s, e, n] }: FieldItem) => [(w + e) / 2, (s + n) / 2];

export function followFarm({ map, fill, visible }: LiveMap): void {
  let drawn: unknown[] = [];
  let fitted = false;
  const sync = () => {
    const { list, open, choosing } = fields.get();
    const { ticked } = farm.get();
    visible(PARTS, session.get().view === 'fields' && choosing === null);
    const now = [list, open?.id, ticked, measures.get()];
    if (now.every((one, i) => one === drawn[i])) return;
    drawn = now;
    const shapes = (list ?? []).filter(({ id, outline }) => id !== open?.id && outline !== undefined);
    fill('farm', collection(shapes.map((field): Feature => ({
      type: 'Feature', geometry: field.outline!, properties: { id: field.id, ticked: ticked.has(field.id), planned: field.last_plan != null },
    }))));
    fill('farm-places', collection(shapes.map((field): Feature => ({
      type: 'Feature', geometry: { type: 'Point', coordinates: middle(field) }, properties: { id: field.id, label: label(field) },
    }))));
    const box = farmBox(list ?? []);
    if (!fitted && box && !open) {
      fitted = true;
      fit(map, box);
    }
  };
  for (const from of [fields, farm, session, measures]) from.listen(sync);
  sync();
  map.on('click', ['farm', 'farm-place', 'farm-name'], (event) => {
    const id = event.features?.[0]?.properties['id'] as string | undefined;
    if (id && !drawing.get().purpose && session.get().view === 'fields' && fields.get().choosing === null) void attempt(() => openField(id));
  });
}
