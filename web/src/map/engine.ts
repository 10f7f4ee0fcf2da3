// The map itself: made once, then kept in step with the stores. Loaded after the first paint.
import maplibregl, { type GeoJSONSource, type Map as GlMap } from 'maplibre-gl';
import { complain } from '../actions/notices';
import type { Box, Place } from '../api/types';
import { measures } from '../measures';
import { distance } from '../metres';
import { fields } from '../state/fields';
import { isNight, session, tilesHost } from '../state/session';
import * as camera from './camera';
import { drawGrid, scaleOf, type Scale } from './grid';
import { drawLabels, forgetLabels } from './labels';
import type { LiveMap } from './live_map';
import { DAY, NIGHT } from './palette';
import { followChoosing } from './show_choosing';
import { followDrawing } from './show_drawing';
import { followFarm } from './show_farm';
import { followField } from './show_field';
import { followPlan } from './show_plan';
import { followRoutePlay } from './show_route_play';
import { followWork } from './show_work';
import { mapStyle } from './layers/style';
import { t } from '../words';

const START: Place = [10, 51];
let shown: LiveMap | null = null;

export const fit = (box: Box) => shown && camera.fit(shown.map, box);
export const look = (at: Place, size_m: number) => shown && camera.look(shown.map, at, size_m);
export const zoomBy = (steps: number) => shown && camera.zoomBy(shown.map, steps);
export const resized = () => shown?.map.resize();

/** Metres counted from farther away than this are not those of the place any more, and lines would end within sight. */
const FARTHEST_M = 20_000;
function keepGrid(map: GlMap, scaled: (scale: Scale) => void): void {
  let origin: Place = START;
  const draw = () => {
    const middle = map.getCenter().toArray();
    if (distance(origin, middle) > FARTHEST_M) origin = middle;
    const grid_m = drawGrid(map, origin);
    scaled({ ...scaleOf(map), grid_m });
  };
  const anchor = () => {
    const box = fields.get().open?.bbox;
    if (box) origin = [box[0], box[1]];
    draw();
  };
  map.on('moveend', draw);
  map.on('resize', draw);
  measures.listen(draw);
  fields.listen(anchor);
  anchor();
}

function keepTheme(map: GlMap): void {
  let night = isNight();
  session.listen(() => {
    if (isNight() === night) return;
    night = isNight();
    const colours = night ? NIGHT : DAY;
    const visibility = map.getStyle().layers.map((layer) => [layer.id, layer.layout?.visibility] as const);
    for (const layer of mapStyle(colours, session.get().info).layers) {
      for (const [name, value] of Object.entries(layer.paint ?? {})) map.setPaintProperty(layer.id, name, value);
    }
    for (const [layer, value] of visibility) if (value) map.setLayoutProperty(layer, 'visibility', value);
    forgetLabels(map, colours);
  });
}

/** What would hide the picture of the land where one wants to see it. */
const GROUND = ['field-ground', 'plan:headland', 'plan:subfields'];
const SEEN_THROUGH = 0.35;

/** A background that cannot be loaded is reported once, until it is switched on again. */
function keepTiles(map: GlMap, visible: LiveMap['visible']): void {
  let told = false;
  // What the map still asks for while the page is being left fails, and is no fault.
  let leaving = false;
  addEventListener('pagehide', () => (leaving = true));
  addEventListener('pageshow', () => (leaving = false));
  map.on('error', (event) => {
    if (leaving) return;
    if ((event as { sourceId?: string }).sourceId !== 'tiles') return console.error(event.error);
    if (told || !session.get().tiles) return;
    told = true;
    complain(t`The background could not be loaded from ${tilesHost()}. Check the network and the address after --tiles; everything else works without it.`);
  });
  if (!map.getLayer('tiles')) return;
  const sync = () => {
    if (!session.get().tiles) told = false;
    visible(['tiles'], session.get().tiles);
    for (const layer of GROUND) map.setPaintProperty(layer, 'fill-opacity', session.get().tiles ? SEEN_THROUGH : 1);
  };
  session.listen(sync);
  sync();
}

function keepFocus(map: GlMap): void {
  const canvas = map.getCanvas();
  canvas.setAttribute('aria-label', t`Map. Arrow keys move it, plus and minus zoom. While you draw, Enter sets a corner at the centre.`);
  canvas.setAttribute('role', 'application');
}

export async function startMap(container: HTMLElement, scaled: (scale: Scale) => void): Promise<void> {
  maplibregl.setWorkerUrl('/map-worker.js');
  const map = new maplibregl.Map({
    container,
    style: mapStyle(isNight() ? NIGHT : DAY, session.get().info),
    center: START,
    zoom: 15,
    maxZoom: 22,
    minZoom: 0,
    attributionControl: false,
    dragRotate: false,
    pitchWithRotate: false,
    touchPitch: false,
    fadeDuration: 0,
    renderWorldCopies: false,
    locale: { 'Map.Title': t`Map` },
  });
  map.touchZoomRotate.disableRotation();
  map.keyboard.disableRotation();
  drawLabels(map, () => (isNight() ? NIGHT : DAY));
  keepFocus(map);
  await map.once('load');
  shown = {
    map,
    fill: (source, data) => void (map.getSource(source) as GeoJSONSource).setData(data as never),
    visible: (layers, on) => {
      for (const layer of layers) map.setLayoutProperty(layer, 'visibility', on ? 'visible' : 'none');
    },
  };
  keepGrid(map, scaled);
  keepTheme(map);
  keepTiles(map, shown.visible);
  followFarm(shown);
  followField(shown);
  followPlan(shown);
  followWork(shown);
  followRoutePlay(shown);
  followDrawing(shown);
  followChoosing(shown);
  container.dataset['ready'] = 'true';
  // For the tests of the page, which look at what is drawn.
  Object.assign(window, { tramlineMap: map });
}
