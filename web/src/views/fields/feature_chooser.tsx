// Which of the fields of a file?
import type { JSX } from 'preact';
import { useEffect, useMemo, useState } from 'preact/hooks';
import { stopTaking, takeFeature, takeFeatures } from '../../actions/fields';
import { attempt } from '../../actions/notices';
import type { Geometry, Place, Upload, UploadedFeature } from '../../api/types';
import { count, hectares, plural, sentence } from '../../format';
import { Button } from '../../parts/button';
import { Select } from '../../parts/choice';
import { folded, Search, typedWords } from '../../parts/search';
import { Windowed } from '../../parts/windowed';
import { sorted, SORTINGS, wordsOf, type Sorting } from '../../state/chooser';
import { calledField, fields, keyOf } from '../../state/fields';
import { useStore } from '../../state/store';
import { told } from '../../program_words';
import { t } from '../../words';

const SIZE = 56;

function ringsOf(shape: UploadedFeature['rings']): Place[][] {
  if (!shape) return [];
  if (Array.isArray(shape)) return shape;
  const { type, coordinates } = shape as Geometry;
  if (type === 'Polygon') return coordinates as Place[][];
  if (type === 'MultiPolygon') return (coordinates as Place[][][]).flat();
  return [];
}

function Preview({ feature }: { feature: UploadedFeature }) {
  const rings = ringsOf(feature.rings);
  const all = rings.flat();
  if (all.length === 0) return <span class="preview" />;
  const shrink = Math.cos((all[0]![1] * Math.PI) / 180);
  const xs = all.map(([lon]) => lon * shrink);
  const ys = all.map(([, lat]) => -lat);
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const scale = (SIZE - 6) / Math.max(Math.max(...xs) - left, Math.max(...ys) - top, 1e-12);
  const d = rings
    .map((ring) => `M${ring.map(([lon, lat]) => `${((lon * shrink - left) * scale + 3).toFixed(1)} ${((-lat - top) * scale + 3).toFixed(1)}`).join('L')}Z`)
    .join('');
  return (
    <svg class="preview" viewBox={`0 0 ${SIZE} ${SIZE}`} aria-hidden="true">
      <path d={d} fill-rule="evenodd" />
    </svg>
  );
}

const about = (feature: UploadedFeature) =>
  feature.refused === null
    ? [hectares(feature.area_m2), feature.crop, feature.obstacles > 0 && plural(feature.obstacles, 'obstacle')].filter(Boolean).join(' · ')
    : t`Cannot be used: ${sentence(told(feature.refused))}`;

const ROW_PX = 84;

/** The list in order, and the words of each, folded once: of a whole register that takes a while. */
function useFound(list: UploadedFeature[], typed: string, sorting: Sorting): UploadedFeature[] {
  const words = useMemo(() => new Map(list.map((feature) => [feature, folded(wordsOf(feature))])), [list]);
  const inOrder = useMemo(() => sorted(list, sorting), [list, sorting]);
  return useMemo(() => {
    const wanted = typedWords(typed);
    return wanted.length === 0 ? inOrder : inOrder.filter((feature) => wanted.every((word) => words.get(feature)!.includes(word)));
  }, [inOrder, typed, words]);
}

const EMPTY: UploadedFeature[] = [];

export function FeatureChooser({ upload }: { upload: Upload }) {
  const busy = useStore(fields, (value) => value.busy);
  const taking = useStore(fields, (value) => value.taking);
  const ticked = useStore(fields, (value) => value.ticked);
  const pointed = useStore(fields, (value) => value.pointed);
  const reached = useStore(fields, (value) => value.reached);
  const [typed, setTyped] = useState('');
  const [sorting, setSorting] = useState<Sorting>('file');
  const list = upload.features ?? EMPTY;
  const found = useFound(list, typed, sorting);
  useEffect(() => fields.set({ found }), [found]);
  useEffect(() => () => fields.set({ found: [], ticked: new Set(), pointed: null, reached: null }), []);
  const usable = found.filter((feature) => feature.refused === null);
  const chosen = list.filter((feature) => ticked.has(keyOf(feature)));
  const tick = (some: UploadedFeature[], on: boolean) => {
    const next = new Set(ticked);
    for (const feature of some) on ? next.add(keyOf(feature)) : next.delete(keyOf(feature));
    fields.set({ ticked: next });
  };
  const allTicked = usable.length > 0 && usable.every((feature) => ticked.has(keyOf(feature)));
  const row = (i: number, place?: JSX.CSSProperties) => {
    const feature = found[i]!;
    const key = keyOf(feature);
    return (
      <li key={key} class={key === pointed ? 'row tight pointed' : 'row tight'} style={place}>
        <label class="tick">
          <input type="checkbox" aria-label={t`Tick ${calledField(feature)}`} checked={ticked.has(key)} disabled={feature.refused !== null || busy !== null}
            onChange={(event) => tick([feature], event.currentTarget.checked)} />
        </label>
        <button type="button" class="card grow" disabled={feature.refused !== null || busy !== null} onMouseEnter={() => fields.set({ pointed: key })}
          onClick={() => void attempt(() => takeFeature(upload, feature))}>
          <Preview feature={feature} />
          <span class="grow">
            <strong>{calledField(feature)}</strong>
            <span class="sub">{about(feature)}</span>
          </span>
        </button>
      </li>
    );
  };
  return (
    <section aria-labelledby="choose-title">
      <h2 id="choose-title">{t`Which field of ${upload.name}?`}</h2>
      <p class="hint">{t`Click a field to open it. To store several at once, tick them here or click them on the map.`}</p>
      {list.length > 1 && (
        <>
          <Search label={t`Search by name, area or any other attribute`} typed={typed} found={found.length} all={list.length} list="features" change={setTyped} />
          <Select label={t`In the order of`} value={sorting} options={SORTINGS} change={setSorting} />
        </>
      )}
      {usable.length > 1 && (
        <label class="tick">
          <input type="checkbox" checked={allTicked} disabled={busy !== null} onChange={() => tick(usable, !allTicked)} />
          <span>{typed.trim() === '' ? t`All ${count(usable.length)} fields` : t`All ${count(usable.length)} that were found`}</span>
        </label>
      )}
      <Windowed id="features" label={t`Fields of the file`} count={found.length} row_px={ROW_PX} row={row} wanted={reached ? found.findIndex((feature) => keyOf(feature) === reached) : null} />
      <div class="sticky foot">
        {busy && <p class="hint" role="status">{busy}</p>}
        <div class="row">
          {chosen.length > 0 && !taking && <Button kind="main" disabled={busy !== null} onClick={() => void attempt(() => takeFeatures(upload, chosen))}>{t`Store ${plural(chosen.length, 'field')}`}</Button>}
          {taking ? <Button onClick={stopTaking}>{t`Stop`}</Button> : <Button disabled={busy !== null} onClick={() => fields.set({ choosing: null })}>{t`Back`}</Button>}
        </div>
      </div>
    </section>
  );
}
