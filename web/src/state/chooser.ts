// Finding fields in a file by any of their words, and the order they are listed in.
import type { UploadedFeature } from '../api/types';
import { hectares } from '../format';
import { calledField } from './fields';
import { t } from '../words';

export type Sorting = 'file' | 'name' | 'large' | 'small' | 'crop';
export const SORTINGS: { value: Sorting; label: string }[] = [
  { value: 'file', label: t`as in the file` },
  { value: 'name', label: t`name` },
  { value: 'large', label: t`area, the largest first` },
  { value: 'small', label: t`area, the smallest first` },
  { value: 'crop', label: t`crop` },
];

const byWords = new Intl.Collator('en-GB', { numeric: true }).compare;
const ORDER: Record<Sorting, ((a: UploadedFeature, b: UploadedFeature) => number) | null> = {
  file: null,
  name: (a, b) => byWords(calledField(a), calledField(b)),
  large: (a, b) => b.area_m2 - a.area_m2,
  small: (a, b) => a.area_m2 - b.area_m2,
  crop: (a, b) => byWords(a.crop || '\uffff', b.crop || '\uffff'),
};
export function sorted(list: UploadedFeature[], by: Sorting): UploadedFeature[] {
  const order = ORDER[by];
  return order ? [...list].sort(order) : list;
}

/** Everything that is known of a field in words. */
export const wordsOf = (feature: UploadedFeature): string =>
  [calledField(feature), feature.id, hectares(feature.area_m2), ...Object.values(feature.attributes ?? {}), feature.refused ?? ''].join(' ');
