// Which of the fields of a file?
import { useState } from 'preact/hooks';
import { stopTaking, takeFeature, takeFeatures } from '../../actions/fields';
import { attempt } from '../../actions/notices';
import type { Geometry, Place, Upload, UploadedFeature } from '../../api/types';
import { hectares, plural, sentence } from '../../format';
import { Button } from '../../parts/button';
import { arrowKeys, matching, Search } from '../../parts/search';
import { fields } from '../../state/fields';
import { useStore } from '../../state/store';

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

const keyOf = (feature: UploadedFeature) => `${feature.layer ?? ''}/${feature.fid}/${feature.id}`;
const about = (feature: UploadedFeature) =>
  feature.refused === null
    ? `${hectares(feature.area_m2)}${feature.obstacles > 0 ? ` · ${plural(feature.obstacles, 'obstacle')}` : ''}`
    : `Cannot be used: ${sentence(feature.refused)}`;

export function FeatureChooser({ upload }: { upload: Upload }) {
  const busy = useStore(fields, (value) => value.busy);
  const taking = useStore(fields, (value) => value.taking);
  const [typed, setTyped] = useState('');
  const [ticked, setTicked] = useState<ReadonlySet<string>>(new Set());
  const list = upload.features ?? [];
  const total = upload.features_total ?? list.length;
  const found = matching(list, typed, (feature) => `${feature.id} ${about(feature)}`);
  const usable = found.filter((feature) => feature.refused === null);
  const chosen = list.filter((feature) => ticked.has(keyOf(feature)));
  const tick = (some: UploadedFeature[], on: boolean) => {
    const next = new Set(ticked);
    for (const feature of some) on ? next.add(keyOf(feature)) : next.delete(keyOf(feature));
    setTicked(next);
  };
  const allTicked = usable.length > 0 && usable.every((feature) => ticked.has(keyOf(feature)));
  return (
    <section aria-labelledby="choose-title">
      <h2 id="choose-title">Which field of {upload.name}?</h2>
      {total > list.length && (
        <p class="fault">
          The file has {plural(total, 'field')}, of which the first {list.length} are listed. Split it into smaller files to reach the others.
        </p>
      )}
      <p class="hint">Click a field to open it. To store several at once, tick them.</p>
      {list.length > 1 && <Search label="Search by name or area" typed={typed} found={found.length} all={list.length} list="features" change={setTyped} />}
      {usable.length > 1 && (
        <label class="tick">
          <input type="checkbox" checked={allTicked} disabled={busy !== null} onChange={() => tick(usable, !allTicked)} />
          <span>{typed.trim() === '' ? `All ${usable.length} fields` : `All ${usable.length} that were found`}</span>
        </label>
      )}
      <ul class="cards" id="features" onKeyDown={arrowKeys}>
        {found.map((feature) => (
          <li key={keyOf(feature)} class="row tight">
            <label class="tick">
              <input type="checkbox" aria-label={`Tick ${feature.id}`} checked={ticked.has(keyOf(feature))} disabled={feature.refused !== null || busy !== null}
                onChange={(event) => tick([feature], event.currentTarget.checked)} />
            </label>
            <button
              type="button" class="card grow" disabled={feature.refused !== null || busy !== null}
              onClick={() => void attempt(() => takeFeature(upload, feature))}
            >
              <Preview feature={feature} />
              <span class="grow">
                <strong>{feature.id}</strong>
                <span class="sub">{about(feature)}</span>
              </span>
            </button>
          </li>
        ))}
      </ul>
      <div class="sticky foot">
        {busy && <p class="hint" role="status">{busy}</p>}
        <div class="row">
          {chosen.length > 0 && !taking && <Button kind="main" disabled={busy !== null} onClick={() => void attempt(() => takeFeatures(upload, chosen))}>Store {plural(chosen.length, 'field')}</Button>}
          {taking ? <Button onClick={stopTaking}>Stop</Button> : <Button disabled={busy !== null} onClick={() => fields.set({ choosing: null })}>Back</Button>}
        </div>
      </div>
    </section>
  );
}
