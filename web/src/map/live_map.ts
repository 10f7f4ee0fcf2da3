// What the parts of the map have in common.
import type { Map as GlMap } from 'maplibre-gl';
import type { FeatureCollection } from '../api/types';

export interface LiveMap {
  map: GlMap;
  /** Replaces what a source holds. */
  fill(source: string, data: FeatureCollection): void;
  /** Shows or hides layers. */
  visible(layers: string[], on: boolean): void;
}

export const NOTHING: FeatureCollection = { type: 'FeatureCollection', features: [] };
export const collection = (features: FeatureCollection['features']): FeatureCollection => ({ type: 'FeatureCollection', features });
