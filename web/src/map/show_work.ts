import type { GeoJSONSource } from 'maplibre-gl';
import { onFrame } from '../actions/play/replay';
import type { FeatureCollection, Place, WorkFrame, WorkTile } from '../api/types';
import { replay } from '../state/replay';
import { DRIVE_LAYERS, review } from '../state/review';
import { session } from '../state/session';
import { fit } from './camera';
import { collection, NOTHING, type LiveMap } from './live_map';
import { TILE_SOURCES } from './layers/style';
import { DRIVE_PARTS } from './layers/work_layers';

type Polygons = WorkTile['covered'];
const LAND_KINDS = ['covered', 'repeated'] as const;
/** Of the way driven, the newest so many places are drawn. */
const TAIL = 4000;

/** Changes only the tiles that came with the frame. */
function growTiles(source: GeoJSONSource, tiles: WorkTile[], kind: (typeof LAND_KINDS)[number], there: Set<string>): void {
  const remove: string[] = [];
  const add = [];
  for (const tile of tiles) {
    const coordinates: Polygons = tile[kind];
    if (coordinates.length > 0) {
      there.add(tile.id);
      // Known by its own id: changes that wait to be drawn are put together by feature.id, whatever promoteId says.
      add.push({ type: 'Feature', id: tile.id, properties: {}, geometry: { type: 'MultiPolygon', coordinates } });
    } else if (there.delete(tile.id)) remove.push(tile.id);
  }
  if (add.length + remove.length > 0) void source.updateData({ add, remove } as never);
}

/** Follows a stream of work: land by tiles, the way driven, the machine. */
function followStream({ map, fill }: LiveMap): void {
  const there = { covered: new Set<string>(), repeated: new Set<string>() };
  let way: Place[] = [];
  const clear = () => {
    for (const name of TILE_SOURCES) fill(name, NOTHING);
    for (const kind of LAND_KINDS) there[kind].clear();
    way = [];
    fill('work:line', NOTHING);
    fill('work:machine', NOTHING);
  };
  const draw = (frame: WorkFrame) => {
    if (frame.all) clear();
    for (const kind of LAND_KINDS) growTiles(map.getSource(`work:${kind}`) as GeoJSONSource, frame.tiles, kind, there[kind]);
    way = [...way, ...frame.line].slice(-TAIL);
    fill('work:line', collection([{ type: 'Feature', properties: {}, geometry: { type: 'LineString', coordinates: way } }]));
    if (!frame.at) return;
    fill('work:machine', collection([{
      type: 'Feature',
      properties: { work: frame.working ? 'on' : 'off', heading: frame.heading_deg ?? 0 },
      geometry: { type: 'Point', coordinates: frame.at },
    }]));
    if (replay.get().of === 'feed' && (replay.get().follows || !map.getBounds().contains(frame.at))) map.setCenter(frame.at);
  };
  onFrame((frame) => (frame ? draw(frame) : clear()));
}

export function followWork(shown: LiveMap): void {
  const { map, fill, visible } = shown;
  followStream(shown);
  const filled: Record<string, FeatureCollection | undefined> = {};
  let looked: string | null = null;
  const sync = () => {
    const here = session.get().view === 'review';
    const { drive, shapes, shown: on } = review.get();
    if (drive && drive.id !== looked && drive.field === null && drive.bbox) fit(map, drive.bbox);
    looked = drive?.id ?? null;
    const moving = replay.get().of !== null;
    for (const name of DRIVE_LAYERS) {
      const data = drive ? shapes[name] : undefined;
      if (data !== filled[name]) {
        filled[name] = data;
        fill(`drive:${name}`, data ?? NOTHING);
      }
      // While it is replayed the map shows the land as it was, not as it came out.
      visible(DRIVE_PARTS[name]!, here && !moving && on[name] && data !== undefined);
    }
    visible(['work:covered', 'work:repeated', 'work:line', 'work:machine'], here && moving);
    visible(['field-missed'], here && moving && replay.get().of === 'drive');
  };
  review.listen(sync);
  let moving = false;
  replay.listen(() => {
    if ((replay.get().of !== null) === moving) return;
    moving = !moving;
    sync();
  });
  session.listen(sync);
  sync();
}
