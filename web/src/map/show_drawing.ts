// Clicks and keys on the map while something is drawn or an edge is picked.
import { add, stop, undo } from '../actions/drawing';
import type { Feature, Place } from '../api/types';
import { closed, drawing } from '../state/drawing';
import { form } from '../state/plan_form';
import { session } from '../state/session';
import { nearestEdge, openEdges } from './edges';
import { collection, NOTHING, type LiveMap } from './live_map';

function shape(places: Place[], ring: boolean): Feature[] {
  const points: Feature[] = places.map((place) => ({ type: 'Feature', properties: {}, geometry: { type: 'Point', coordinates: place } }));
  if (places.length < 2) return points;
  const line: Feature = { type: 'Feature', properties: {}, geometry: { type: 'LineString', coordinates: ring ? [...places, places[0]!] : places } };
  const area: Feature = { type: 'Feature', properties: {}, geometry: { type: 'Polygon', coordinates: [[...places, places[0]!]] } };
  return ring && places.length > 2 ? [area, line, ...points] : [line, ...points];
}

const guideFeature = (line: Place[], chosen: boolean): Feature => ({
  type: 'Feature', properties: { chosen }, geometry: { type: 'LineString', coordinates: line },
});

/** Gates that a route is asked for. */
function gates(): Feature[] {
  const { route, start, end } = form.get();
  const gate = (place: Place | null, name: string): Feature[] =>
    route && place ? [{ type: 'Feature', properties: { gate: name }, geometry: { type: 'Point', coordinates: place } }] : [];
  return [...gate(end, 'end'), ...gate(start, 'start')];
}

export function followDrawing({ map, fill }: LiveMap): void {
  const sync = () => {
    const { purpose, places } = drawing.get();
    fill('drawing', places.length > 0 ? collection(shape(places, closed(purpose))) : NOTHING);
    map.getCanvas().style.cursor = purpose ? 'crosshair' : '';
    if (purpose) map.doubleClickZoom.disable();
    else map.doubleClickZoom.enable();
  };
  drawing.listen(sync);
  sync();

  const guide = () => {
    const picking = drawing.get().purpose === 'edge';
    const line = form.get().line;
    const here = session.get().view === 'plan' || picking;
    const offered = picking ? openEdges().map((edge) => guideFeature(edge.line, false)) : [];
    const chosen = here && line ? [guideFeature(line, true)] : [];
    fill('edges', collection([...offered, ...chosen, ...(here ? gates() : [])]));
  };
  for (const from of [drawing, form, session]) from.listen(guide);
  guide();

  const take = (place: Place) => {
    if (drawing.get().purpose !== 'edge') return add(place);
    const nearest = nearestEdge(openEdges(), place);
    if (!nearest) return;
    form.set({ line: nearest.edge.line });
    stop();
  };
  map.on('click', (event) => {
    if (drawing.get().purpose) take(event.lngLat.toArray());
  });
  map.getCanvas().addEventListener('keydown', (event) => {
    if (!drawing.get().purpose) return;
    if (event.key === 'Enter' || event.key === ' ') take(map.getCenter().toArray());
    else if (event.key === 'Backspace') undo();
    else if (event.key === 'Escape') stop();
    else return;
    event.preventDefault();
  });
}
