// What to do while drawing, and a way to draw without pointing: coordinates, or metres from the last point.
import { useRef, useState } from 'preact/hooks';
import { add, cancel, finish, moved, redo, removeCorner, reshape, undo } from '../../actions/drawing';
import { complain } from '../../actions/notices';
import type { Place } from '../../api/types';
import { degrees, hectares, metres, plural, squareMetres } from '../../format';
import { unitOf } from '../../measures';
import { boxOf } from '../../map/boxes';
import { engine } from '../../map/engine_loader';
import { directionOf, distance, moved as movedBy, ringArea, shifted, turnedTo } from '../../metres';
import { Button } from '../../parts/button';
import { Slider } from '../../parts/slider';
import { closed, drawing, fixedEnds, least, single, type Purpose } from '../../state/drawing';
import { plans } from '../../state/plans';
import { useStore } from '../../state/store';
import { t } from '../../words';

const CHANGE = t`Drag corners, drag the small dots between them for new ones, or click further corners.`;
const WORDS: Record<Purpose, { title: string; done: string }> = {
  field: { title: t`Click or tap the corners of the field, one after the other; the first once more closes it.`, done: t`Store the field` },
  boundary: { title: CHANGE, done: t`Keep this boundary` },
  'obstacle-point': { title: t`Click or tap the middle of the obstacle.`, done: t`Add the obstacle` },
  'obstacle-line': { title: t`Click or tap the points of the line.`, done: t`Add the obstacle` },
  'obstacle-area': { title: t`Click or tap the corners of the obstacle.`, done: t`Add the obstacle` },
  'obstacle-shape': { title: CHANGE, done: t`Keep this obstacle` },
  guide: { title: t`Click or tap the points of the line that the tracks are to follow.`, done: t`Follow this line` },
  gate: { title: t`Click or tap the gate of the field.`, done: t`Take this place` },
  direction: { title: t`Drag an end of the line: tracks turn with it, and the first swath begins at it.`, done: t`Keep this direction` },
  skip: { title: t`Click or tap the corners of the area that no swath may enter.`, done: t`Forbid this area` },
  exempt: { title: t`Click or tap the corners of the area that need not be worked.`, done: t`Exempt this area` },
  subfield: { title: t`Click or tap the corners of the subfield; over the edge of the field is fine.`, done: t`Make it a subfield` },
  cut: { title: t`Click or tap the points of the line that divides the field.`, done: t`Cut here` },
  lock: { title: t`Click or tap the corners of the part whose tracks stay as they are.`, done: t`Keep this part` },
  edge: { title: t`Click or tap an edge of the field. With the keyboard: move the map until the edge is nearest to its middle, then press Enter.`, done: '' },
};

export function DrawingBar() {
  const purpose = useStore(drawing, (value) => value.purpose);
  const places = useStore(drawing, (value) => value.places);
  if (!purpose) return null;
  const { title, done } = WORDS[purpose];
  const chosen = useStore(drawing, (value) => value.chosen);
  const past = useStore(drawing, (value) => value.past.length);
  const future = useStore(drawing, (value) => value.future.length);
  const ground = closed(purpose) && places.length > 2 ? ringArea(places) : 0;
  const last = places[places.length - 1];
  const before = places[places.length - 2];
  return (
    <div class="drawing-bar" role="group" aria-label={t`Drawing`}>
      <p>
        {title} <strong role="status">{places.length > 0 && !fixedEnds(purpose) && <>{t`${plural(places.length, 'point')} set`}{last && before ? t`, the last ${metres(distance(before, last))} from the one before` : ''}{ground > 0 ? `; ${purpose.startsWith('obstacle') ? squareMetres(ground) : hectares(ground)}` : ''}.</>}</strong>
      </p>
      {purpose === 'direction' && <Turning places={places} />}
      {purpose !== 'edge' && !fixedEnds(purpose) && <TypedPlace last={last ?? null} />}
      <div class="row">
        {purpose !== 'edge' && <Button kind="main" disabled={places.length < least(purpose)} onClick={() => void finish()}>{done}</Button>}
        {purpose !== 'edge' && <Button disabled={past === 0} onClick={undo}>{t`Undo`}</Button>}
        {purpose !== 'edge' && <Button disabled={future === 0} onClick={redo}>{t`Redo`}</Button>}
        {purpose !== 'edge' && !single(purpose) && !fixedEnds(purpose) && <Button disabled={chosen === null} onClick={removeCorner}>{t`Delete the corner`}</Button>}
        <Button onClick={cancel}>{t`Cancel`}</Button>
      </div>
    </div>
  );
}

/** Of the swath, so that whole steps lead to other tracks: a whole swath to the side they are the same. */
const SIDEWAYS = 0.1;

/** The line turned and moved without a pointer; each key, as long as it is held, is one step to undo. */
function Turning({ places }: { places: Place[] }) {
  const before = useRef<Place[] | null>(null);
  const width_m = useStore(plans, (value) => value.open?.summary.width_m ?? 0);
  const deg = directionOf(places);
  const turn = (towards: number) => {
    before.current ??= places;
    reshape(turnedTo(places, towards));
  };
  const settled = () => {
    if (before.current) moved(before.current);
    before.current = null;
  };
  const keyed = ({ key, target }: KeyboardEvent) => {
    if (key === 'Escape') cancel();
    else if (key === 'Enter' && target instanceof HTMLInputElement) void finish();
  };
  const aside = (right_m: number) => {
    reshape(shifted(places, right_m));
    moved(places);
  };
  return (
    <div onKeyDown={keyed}>
      <Slider label={t`Direction`} value={deg} least={0} most={180} step={0.1} stride={1} says={degrees(deg)} focused change={turn} settled={settled} />
      <p class="hint">{t`Arrow keys turn the line by 1°, with Shift by 0.1°.`}</p>
      <div class="row">
        <Button onClick={() => aside(-SIDEWAYS * width_m)}>{t`${metres(SIDEWAYS * width_m)} to the left`}</Button>
        <Button onClick={() => aside(SIDEWAYS * width_m)}>{t`${metres(SIDEWAYS * width_m)} to the right`}</Button>
      </div>
    </div>
  );
}

function TypedPlace({ last }: { last: Place | null }) {
  const [text, setText] = useState('');
  const set = () => {
    const numbers = text.trim().split(/[\s;]+|,\s*/).filter((part) => part !== '').map(Number);
    const [a, b] = numbers;
    if (numbers.length !== 2 || a === undefined || b === undefined || !Number.isFinite(a) || !Number.isFinite(b)) {
      complain(last ? t`Type two numbers: how far to the east and to the north of the last point, in ${unitOf('m').name}, such as “120 -40”.` : t`Type two numbers: latitude and longitude in degrees, such as “52.6925 9.1478”.`);
      return;
    }
    if (!last && (Math.abs(a) > 85 || Math.abs(b) > 180)) {
      complain(t`Latitude goes from −85 to 85, longitude from −180 to 180. Type them in this order.`);
      return;
    }
    const place = last ? movedBy(last, a * unitOf('m').size, b * unitOf('m').size) : ([b, a] as Place);
    add(place);
    const all = drawing.get().places;
    if (all.length < 2) engine()?.look(place, 100);
    else engine()?.fit(boxOf(all)!);
    setText('');
  };
  return (
    <form class="row" onSubmit={(event) => { event.preventDefault(); set(); }}>
      <label class="grow">
        <span class="label">{last ? t`Or ${unitOf('m').name === 'm' ? t`metres` : t`feet`} east and north of the last point` : t`Or latitude and longitude in degrees`}</span>
        <input type="text" autocomplete="off" placeholder={last ? '120 -40' : '52.6925 9.1478'} value={text} onInput={(event) => setText(event.currentTarget.value)} />
      </label>
      <button type="submit" class="button">{t`Set`}</button>
    </form>
  );
}
