// Which of the fields of a file?
import type { Geometry, Place, Upload, UploadedFeature } from '../../api/types';
import { sentence } from '../../api/client';
import { hectares, plural } from '../../format';
import { Button } from '../../parts/button';
import { fields, takeFeature } from '../../state/fields';
import { attempt } from '../../state/notices';
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

export function FeatureChooser({ upload }: { upload: Upload }) {
  const busy = useStore(fields, (value) => value.busy);
  const list = upload.features ?? [];
  const total = upload.features_total ?? list.length;
  return (
    <section aria-labelledby="choose-title">
      <h2 id="choose-title">Which field of {upload.name}?</h2>
      <p class="hint">
        {plural(total, 'field')} in the file{total > list.length ? `, of which the first ${list.length} are listed` : ''}.
      </p>
      <ul class="cards">
        {list.map((feature) => (
          <li key={`${feature.layer ?? ''}/${feature.fid}/${feature.id}`}>
            <button
              type="button" class="card" disabled={feature.refused !== null || busy !== null}
              onClick={() => void attempt(() => takeFeature(upload, feature))}
            >
              <Preview feature={feature} />
              <span class="grow">
                <strong>{feature.id}</strong>
                <span class="sub">
                  {feature.refused === null
                    ? `${hectares(feature.area_m2)}${feature.obstacles > 0 ? ` · ${plural(feature.obstacles, 'obstacle')}` : ''}`
                    : `Cannot be used: ${sentence(feature.refused)}`}
                </span>
              </span>
            </button>
          </li>
        ))}
      </ul>
      <Button onClick={() => fields.set({ choosing: null })}>Back</Button>
    </section>
  );
}
