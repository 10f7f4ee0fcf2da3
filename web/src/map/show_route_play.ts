// The machine on its route, and the way it has driven.
import type { LayerSpecification } from 'maplibre-gl';
import type { Feature, FeatureCollection, Place } from '../api/types';
import { plans } from '../state/plans';
import { routePlay, soFar, waysOf } from '../state/route_play';
import { session } from '../state/session';
import { collection, NOTHING, type LiveMap } from './live_map';
import { bearing, distance } from '../metres';
import type { Colours } from './palette';

export const routePlayLayers = (c: Colours): LayerSpecification[] => [
  {
    id: 'route-driven', type: 'line', source: 'route-driven', layout: { 'line-join': 'round', 'line-cap': 'round' },
    paint: { 'line-color': c.RouteStart, 'line-width': 4, 'line-opacity': 0.7 },
  },
  {
    id: 'route-machine', type: 'symbol', source: 'route-machine',
    layout: {
      'icon-image': ['concat', 'machine:', ['get', 'work']], 'icon-rotate': ['get', 'heading'], 'icon-rotation-alignment': 'map', 'icon-allow-overlap': true,
      'icon-ignore-placement': true,
    },
  },
];

const line = (places: Place[]): Feature => ({ type: 'Feature', properties: {}, geometry: { type: 'LineString', coordinates: places } });

/** The way up to a part of its length, and the heading there. */
function driven(way: Place[], share: number): { way: Place[]; heading_deg: number } {
  const lengths = way.slice(1).map((place, i) => distance(way[i]!, place));
  let left = share * lengths.reduce((sum, one) => sum + one, 0);
  const out = way.slice(0, 1);
  let heading_deg = 0;
  for (let i = 0; i < lengths.length; i++) {
    const [from, to, long] = [way[i]!, way[i + 1]!, lengths[i]!];
    if (long > 0) heading_deg = bearing(from, to);
    const part = long > 0 ? Math.min(1, left / long) : 1;
    out.push([from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])]);
    left -= long;
    if (left <= 0) break;
  }
  return { way: out, heading_deg };
}

export function followRoutePlay({ fill, visible }: LiveMap): void {
  let shapes: FeatureCollection | undefined;
  let ways: Place[][] = [];
  const sync = () => {
    const { plan, at_s } = routePlay.get();
    const { open, shapes: all } = plans.get();
    const here = plan !== null && open?.id === plan && session.get().view === 'plan' && open.summary.route !== undefined;
    visible(['route-driven', 'route-machine'], here);
    if (!here) return;
    const route = open.summary.route!;
    if (all['route_legs'] !== shapes) {
      shapes = all['route_legs'];
      ways = waysOf(shapes, route.legs.length);
    }
    const { leg, share } = soFar(open, at_s);
    const now = ways[leg];
    if (!now || now.length < 2) return;
    const { way, heading_deg } = driven(now, share);
    fill('route-driven', ways.length > 0 ? collection([...ways.slice(0, leg), way].filter((one) => one.length > 1).map(line)) : NOTHING);
    const { work, gear } = route.legs[leg]!;
    fill('route-machine', collection([{
      type: 'Feature', properties: { work: work ? 'on' : 'off', heading: gear === 'reverse' ? (heading_deg + 180) % 360 : heading_deg },
      geometry: { type: 'Point', coordinates: way[way.length - 1]! },
    }]));
  };
  for (const from of [routePlay, plans, session]) from.listen(sync);
  sync();
}
