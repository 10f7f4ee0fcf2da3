// The fields of a file to choose from: all that were found, those that are ticked, and the one that is pointed at.
import type { LayerSpecification } from 'maplibre-gl';
import type { Box, Feature, Geometry, Place, UploadedFeature } from '../api/types';
import { fields, keyOf } from '../state/fields';
import { session } from '../state/session';
import { fit } from './camera';
import { collection, NOTHING, type LiveMap } from './live_map';
import type { Colours } from './palette';

export const choosingLayers = (c: Colours): LayerSpecification[] => [
  { id: 'choosing', type: 'fill', source: 'choosing', paint: { 'fill-color': c.Field, 'fill-outline-color': c.FieldEdge } },
  { id: 'choosing-edge', type: 'line', source: 'choosing', paint: { 'line-color': c.FieldEdge, 'line-width': 1 } },
  { id: 'chosen', type: 'fill', source: 'chosen', paint: { 'fill-color': ['case', ['get', 'pointed'], c.Reference, c.Covered], 'fill-opacity': 0.7 } },
  { id: 'chosen-edge', type: 'line', source: 'chosen', paint: { 'line-color': c.FieldEdge, 'line-width': 2.5 } },
];

const featureOf = (one: UploadedFeature, properties: Record<string, unknown>): Feature => ({ type: 'Feature', properties, geometry: one.rings as Geometry });

function placesOf(one: UploadedFeature): Place[] {
  const shape = one.rings as Geometry | null;
  return shape && shape.type === 'MultiPolygon' ? (shape.coordinates as Place[][][]).flat(2) : [];
}

function boxOf(list: UploadedFeature[]): Box | null {
  const box: Box = [180, 90, -180, -90];
  for (const one of list) {
    for (const [lon, lat] of placesOf(one)) {
      box[0] = Math.min(box[0], lon);
      box[1] = Math.min(box[1], lat);
      box[2] = Math.max(box[2], lon);
      box[3] = Math.max(box[3], lat);
    }
  }
  return box[0] <= box[2] ? box : null;
}

export function followChoosing({ map, fill, visible }: LiveMap): void {
  let found: UploadedFeature[] | null = null;
  let fitted = '';
  const sync = () => {
    const { choosing, found: list, ticked, pointed } = fields.get();
    const here = choosing !== null && session.get().view === 'fields';
    visible(['choosing', 'choosing-edge', 'chosen', 'chosen-edge'], here);
    if (list !== found) {
      found = list;
      fill('choosing', list.length > 0 ? collection(list.map((one) => featureOf(one, { key: keyOf(one) }))) : NOTHING);
      const box = boxOf(list);
      if (here && box && fitted !== box.join()) {
        fitted = box.join();
        fit(map, box);
      }
    }
    const marked = list.filter((one) => ticked.has(keyOf(one)) || keyOf(one) === pointed);
    fill('chosen', marked.length > 0 ? collection(marked.map((one) => featureOf(one, { pointed: keyOf(one) === pointed }))) : NOTHING);
  };
  fields.listen(sync);
  session.listen(sync);
  sync();

  map.on('click', 'choosing', (event) => {
    const key = event.features?.[0]?.properties['key'] as string | undefined;
    const feature = fields.get().found.find((one) => keyOf(one) === key);
    if (!key || !feature || feature.refused !== null) return;
    const ticked = new Set(fields.get().ticked);
    if (!ticked.delete(key)) ticked.add(key);
    fields.set({ ticked, pointed: key, reached: key });
  });
}
