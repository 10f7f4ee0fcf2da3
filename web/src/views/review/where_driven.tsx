// Was the log driven on the field that is chosen? Where not, which way to go on?
import type { Box, FieldItem } from '../../api/types';
import { farness } from '../../format';
import { apart_m, shared } from '../../map/boxes';
import { Button } from '../../parts/button';
import { t } from '../../words';

/** The stored field that shares most with where a log was driven. */
export function fieldBelow(bbox: Box | null, list: readonly FieldItem[]): FieldItem | null {
  if (bbox === null) return null;
  let best: FieldItem | null = null;
  for (const field of list) {
    if (field.geodetic && shared(bbox, field.bbox) > (best ? shared(bbox, best.bbox) : 0)) best = field;
  }
  return best;
}

/** How far from the field the log was driven, m; null where they meet, or where one of them lies nowhere on earth. */
export function farFrom(bbox: Box | null, field: FieldItem | undefined): number | null {
  if (bbox === null || !field || !field.geodetic) return null;
  const far_m = apart_m(bbox, field.bbox);
  return far_m > 0 ? far_m : null;
}

interface Props {
  bbox: Box | null;
  /** The field that is open, and the one that is chosen in the form. */
  open: FieldItem | undefined;
  chosen: FieldItem | undefined;
  below: FieldItem | null;
  /** Shows the drive with this field, or with none. */
  go: (field: string) => void;
}

export function WhereDriven({ bbox, open, chosen, below, go }: Props) {
  const far_m = farFrom(bbox, chosen);
  if (chosen && far_m !== null) {
    return (
      <div class="notice error" role="alert">
        <div class="grow">
          <p>{t`This log was not driven on ${chosen.name}, but ${farness(far_m)} away from it.`} {below ? t`It was driven on ${below.name}.` : t`None of your fields lies there: add that field first, or go on without one.`}</p>
          <div class="row">
            {below && <Button onClick={() => go(below.id)}>{t`Show it on ${below.name}`}</Button>}
            <Button onClick={() => go('')}>{t`Show it without a field`}</Button>
          </div>
        </div>
      </div>
    );
  }
  const openFar_m = farFrom(bbox, open);
  if (open && openFar_m !== null && chosen?.id !== open.id) {
    return (
      <p class="notice told">
        {t`This log was not driven on ${open.name}, which is open, but ${farness(openFar_m)} away from it.`} {chosen ? t`It was driven on ${chosen.name}, which is chosen below.` : t`None of your fields lies there, so none is chosen below.`}
      </p>
    );
  }
  return null;
}
