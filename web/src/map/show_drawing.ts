// Clicks and keys on the map while something is drawn or an edge is picked.
import type { MapLayerMouseEvent, MapLayerTouchEvent } from 'maplibre-gl';
import { add, cancel, choose, finish, insert, move, moved, redo, removeCorner, stop, undo } from '../actions/drawing';
import { edit } from '../actions/hand';
import type { Feature, Place } from '../api/types';
import { closed, drawing, fixedEnds, least, single } from '../state/drawing';
import { form } from '../state/plan_form';
import { session } from '../state/session';
import { nearestEdge, openEdges } from './edges';
import { collection, NOTHING, type LiveMap } from './live_map';

/** Corners, and between any two a smaller one, from which a new corner is dragged. */
function corners(places: Place[], ring: boolean, chosen: number | null, fixed: boolean): Feature[] {
  const point = (place: Place, properties: Record<string, unknown>): Feature => ({ type: 'Feature', properties, geometry: { type: 'Point', coordinates: place } });
  const between = fixed ? [] : places.flatMap((place, i) => {
    const next = i + 1 < places.length ? places[i + 1] : ring && places.length > 2 ? places[0] : undefined;
    return next ? [point([(place[0] + next[0]) / 2, (place[1] + next[1]) / 2], { after: i, between: true, chosen: false })] : [];
  });
  return [...between, ...places.map((place, i) => point(place, { corner: i, between: false, chosen: i === chosen }))];
}

function shape(places: Place[], ring: boolean, chosen: number | null, fixed: boolean): Feature[] {
  const points = corners(places, ring, chosen, fixed);
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

/** A finger is wider than a corner. */
const REACH_PX = 14;
/** Of a drag, with whatever it began. */
const ENDS = ['mouseup', 'touchend', 'touchcancel'] as const;

export function followDrawing({ map, fill }: LiveMap): void {
  const sync = () => {
    const { purpose, places, chosen } = drawing.get();
    fill('drawing', places.length > 0 ? collection(shape(places, closed(purpose), chosen, fixedEnds(purpose))) : NOTHING);
    map.getCanvas().style.cursor = purpose ? 'crosshair' : '';
    if (purpose) map.doubleClickZoom.disable();
    else map.doubleClickZoom.enable();
  };
  drawing.listen(sync);
  sync();

  const guide = () => {
    const picking = drawing.get().purpose === 'edge';
    const line = form.get().line;
    const { land } = form.get();
    const here = session.get().view === 'plan' || picking;
    const offered = picking ? openEdges().map((edge) => guideFeature(edge.line, false)) : [];
    const chosen = here && line ? [guideFeature(line, true)] : [];
    fill('edges', collection([...offered, ...chosen, ...(here ? gates() : [])]));
    fill('land', collection(here ? land.map(({ kind, geometry }) => ({ type: 'Feature' as const, properties: { kind }, geometry })) : []));
  };
  for (const from of [drawing, form, session]) from.listen(guide);
  guide();

  const take = (place: Place, by: 'pointer' | 'keys') => {
    if (drawing.get().purpose !== 'edge') return add(place, by);
    const nearest = nearestEdge(openEdges(), place);
    if (!nearest) return;
    edit({ line: nearest.edge.line });
    stop();
  };
  /** The shape is done where the first corner is met again. */
  const closes = (at: { x: number; y: number }): boolean => {
    const { purpose, places } = drawing.get();
    const first = places[0];
    if (!purpose || !first || !closed(purpose) || places.length < least(purpose)) return false;
    const there = map.project(first);
    return Math.hypot(there.x - at.x, there.y - at.y) <= REACH_PX;
  };
  let dragged = false;
  map.on('click', (event) => {
    const { purpose } = drawing.get();
    if (!purpose) return;
    if (dragged) return;
    if (closes(event.point)) void finish();
    else if (drawing.get().chosen === null || map.queryRenderedFeatures(event.point, { layers: ['drawing-point'] }).length === 0) take(event.lngLat.toArray(), 'pointer');
  });

  const grab = (event: MapLayerMouseEvent | MapLayerTouchEvent) => {
    const { purpose, places } = drawing.get();
    const grip = event.features?.[0]?.properties;
    if (!purpose || single(purpose) || !grip) return;
    event.preventDefault(); // the map stays where it is
    dragged = false;
    const before = places;
    let corner = typeof grip['corner'] === 'number' ? grip['corner'] : null;
    if (corner !== null) choose(corner);
    const drag = (moving: { lngLat: { toArray(): [number, number] } }) => {
      if (corner === null) {
        insert(grip['after'] as number, moving.lngLat.toArray());
        corner = (grip['after'] as number) + 1;
      } else move(corner, moving.lngLat.toArray());
      dragged = true;
    };
    const drop = () => {
      map.off('mousemove', drag);
      map.off('touchmove', drag);
      for (const end of ENDS) map.off(end, drop);
      removeEventListener('mouseup', drop);
      if (dragged && grip['between'] !== true) moved(before);
      setTimeout(() => (dragged = false)); // after the click, where one comes of it
    };
    map.on('mousemove', drag);
    map.on('touchmove', drag);
    for (const end of ENDS) map.on(end, drop);
    addEventListener('mouseup', drop); // also beside the map
  };
  map.on('mousedown', 'drawing-point', grab);
  map.on('touchstart', 'drawing-point', grab);

  map.getCanvas().addEventListener('keydown', (event) => {
    const { purpose, places, pointed } = drawing.get();
    if (!purpose) return;
    const middle = map.getCenter();
    if (event.key === 'Enter' && purpose !== 'edge' && places.length >= least(purpose) && (pointed || closes(map.project(middle)))) void finish();
    else if (event.key === 'Enter' || event.key === ' ') take(middle.toArray(), 'keys');
    else if (event.key.toLowerCase() === 'z' && (event.ctrlKey || event.metaKey)) event.shiftKey ? redo() : undo();
    else if (event.key.toLowerCase() === 'y' && (event.ctrlKey || event.metaKey)) redo();
    else if (event.key === 'Backspace' || event.key === 'Delete') removeCorner();
    else if (event.key === 'Escape') cancel();
    else return;
    event.preventDefault();
  });
}
