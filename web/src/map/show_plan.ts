import { attempt } from '../actions/notices';
import { refineLayers } from '../actions/plans';
import type { FeatureCollection } from '../api/types';
import { isShown, plans } from '../state/plans';
import { replay } from '../state/replay';
import { session } from '../state/session';
import { NOTHING, type LiveMap } from './live_map';
import { degreeLengths } from '../metres';
import { PARTS_OF } from './layers/plan_layers';
import { endsOf } from './route_ends';

/** Lines nearer to one another than this are a grey area, and cost as much to draw as if they were seen, px. */
const LEAST_APART_PX = 3;

/** How wide a swath is on the screen at a zoom, px: MapLibre's world is 512 px wide at zoom 0. */
function swathPx(width_m: number, lat: number, zoom: number): number {
  return (width_m * 512 * 2 ** zoom) / (degreeLengths(lat)[0] * 360);
}

/** From afar every second track is drawn, or every fourth, and so on; all of them from near. Whole tracks: pieces of neighbours take turns in the order. */
function thinned(width_m: number, lat: number): unknown[] {
  const every = (zoom: number) => 2 ** Math.max(0, Math.ceil(Math.log2(LEAST_APART_PX / swathPx(width_m, lat, zoom))));
  const steps = Array.from({ length: 18 }, (_, i) => i + 5).flatMap((zoom) => [zoom, every(zoom)]);
  return ['==', ['%', ['to-number', ['get', 'track'], 0], ['step', ['zoom'], every(4), ...steps]], 0];
}

function zoomOf(width_m: number, lat: number, px: number): number {
  return Math.max(0, Math.min(22, Math.log2(px / swathPx(width_m, lat, 0))));
}

const GUIDANCE = ['tracks', 'headland_passes'];

/** The open plan on the map, while a view is open that is about plans. */
export function followPlan({ map, fill, visible }: LiveMap): void {
  const filled: Record<string, FeatureCollection | undefined> = {};
  let fitted: string | null = null;
  const sync = () => {
    const { view } = session.get();
    const { shapes, open } = plans.get();
    const plans_here = view === 'plan' || view === 'compare';
    // In the cab the lines of the plan lie over the work.
    const guiding = view === 'review' && replay.get().of === 'feed';
    for (const [name, parts] of Object.entries(PARTS_OF)) {
      const on = (plans_here || (guiding && GUIDANCE.includes(name))) && open !== null && isShown(name);
      const data = on ? shapes[name] : undefined;
      if (on && data !== filled[name]) {
        filled[name] = data;
        fill(`plan:${name}`, data ?? NOTHING);
        if (name === 'route_legs') fill('plan:route_ends', data ? endsOf(data) : NOTHING);
      }
      visible(parts, on && data !== undefined);
    }
    if (open && open.id !== fitted) {
      fitted = open.id;
      const [width_m, lat] = [open.summary.width_m, (open.bbox[1] + open.bbox[3]) / 2];
      map.setFilter('plan:tracks', thinned(width_m, lat) as never);
      map.setLayerZoomRange('plan:swaths-edge', zoomOf(width_m, lat, 4), 24);
      for (const layer of ['plan:tracks-number', 'plan:tracks-arrow']) map.setLayerZoomRange(layer, zoomOf(width_m, lat, LEAST_APART_PX), 24);
    }
  };
  map.on('zoomend', () => {
    const { open, detail_m } = plans.get();
    if (!open) return;
    const pixel_m = 1 / swathPx(1, map.getCenter().lat, map.getZoom());
    if (pixel_m < detail_m) void attempt(refineLayers);
  });
  plans.listen(sync);
  session.listen(sync);
  let guiding = false;
  replay.listen(() => {
    if (guiding === (replay.get().of === 'feed')) return;
    guiding = !guiding;
    sync();
  });
  sync();
}
