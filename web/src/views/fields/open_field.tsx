import { useEffect, useRef } from 'preact/hooks';
import { drawFor } from '../../actions/drawing';
import { changeField } from '../../actions/fields';
import { takeFocus } from '../../actions/focus';
import { attempt } from '../../actions/notices';
import { show } from '../../actions/session';
import type { FieldFull, Geometry, Place } from '../../api/types';
import { hectares, plural, sentence, squareMetres } from '../../format';
import { boxOf } from '../../map/boxes';
import { engine } from '../../map/engine_loader';
import { distance } from '../../metres';
import { Button } from '../../parts/button';
import { Expander } from '../../parts/expander';
import { TitleField } from '../../parts/title_field';
import { AddObstacle } from './add_obstacle';
import { told } from '../../program_words';
import { t } from '../../words';

export function OpenField({ field }: { field: FieldFull }) {
  const region = useRef<HTMLElement>(null);
  useEffect(() => takeFocus(region.current), [field.id]);
  return (
    <section ref={region} class="open" tabIndex={-1} aria-label={t`Open field: ${field.name}`}>
      <TitleField key={field.id} label={t`Name of the field`} value={field.name} save={(name) => void attempt(() => changeField({ name }))} />
      <p>
        <strong>{hectares(field.area_m2)}</strong>
        {` · ${field.obstacles === 0 ? t`no obstacles` : plural(field.obstacles, 'obstacle')}`}
        {field.passable > 0 && ` · ${plural(field.passable, 'passable strip')}`}
        {!field.geodetic && t` · plain metres`}
      </p>
      <div class="two">
        <TitleField key={`${field.id} crop`} label={t`Crop`} seen value={field.crop} save={(crop) => void attempt(() => changeField({ crop }))} />
        <TitleField key={`${field.id} tags`} label={t`Tags`} seen value={field.tags.join(', ')} save={(text) => void attempt(() => changeField({ tags: text.split(/[,;#]/).map((tag) => tag.trim()).filter((tag) => tag !== '') }))} />
      </div>
      <Findings field={field} />
      <Obstacles field={field} />
      <AddObstacle />
      <Button onClick={() => drawFor('boundary', (boundary) => changeField({ boundary }), { places: ringOf(field) })}>{t`Change the boundary`}</Button>
      <Button kind="main" onClick={() => show('plan')}>{t`Plan this field`}</Button>
    </section>
  );
}

/** The corners of the outer boundary. */
function ringOf(field: FieldFull): Place[] {
  const shape = field.shapes.features.find(({ properties }) => properties['kind'] === 'field')?.geometry;
  return shape?.type === 'Polygon' ? (shape.coordinates as Place[][])[0]!.slice(0, -1) : [];
}

function obstacleRings(field: FieldFull, number: number): Place[][] {
  const shape = field.shapes.features.find(({ properties }) => properties['number'] === number && properties['kind'] !== 'field')?.geometry;
  return shape?.type === 'Polygon' ? (shape.coordinates as Place[][]) : [];
}
/** The corners of an obstacle as it lies on the field. */
const obstacleRing = (field: FieldFull, number: number): Place[] => obstacleRings(field, number)[0]?.slice(0, -1) ?? [];
/** An outline that was drawn anew keeps the land within it that is none of the obstacle. */
const withHoles = (outline: Geometry, field: FieldFull, number: number): Geometry =>
  ({ ...outline, coordinates: [...(outline.coordinates as Place[][]), ...obstacleRings(field, number).slice(1)] });

function changeObstacle(field: FieldFull, number: number, kind: string): void {
  const places = obstacleRing(field, number);
  const box = boxOf(places);
  // From near, with room to drag: the corners of a pond lie on one another where a whole farm is in sight.
  if (box) engine()?.look([(box[0] + box[2]) / 2, (box[1] + box[3]) / 2], distance([box[0], box[1]], [box[2], box[3]]) / 2);
  drawFor('obstacle-shape', (geometry) => changeField({ remove: [number], add: [{ kind: kind === 'passable' ? 'passable' : 'obstacle', geometry: withHoles(geometry, field, number) }] }), { places });
}

function Findings({ field }: { field: FieldFull }) {
  const { repairs, skipped, warnings } = field;
  const number = repairs.length + skipped.length + warnings.length;
  if (number === 0) return <p class="fine">{t`The boundary is sound: nothing had to be mended.`}</p>;
  return (
    <Expander title={t`${plural(number, 'remark')} on the file: what was mended or skipped`} open={number <= 4}>
      <ul class="plain">
        {repairs.map((repair, i) => (
          <li key={i}>
            {sentence(t`mended: ${told(repair.what)}`)} <span class="sub">{told(repair.where)}{repair.area_change_m2 ? `, ${squareMetres(repair.area_change_m2)}` : ''}</span>
          </li>
        ))}
        {skipped.map((skip, i) => (
          <li key={i}>{sentence(t`skipped: ${skip.what}, ${skip.why}`)} <span class="sub">{skip.where}</span></li>
        ))}
        {warnings.map((warning, i) => <li key={i}>{sentence(told(warning))}</li>)}
      </ul>
    </Expander>
  );
}

interface Obstacle {
  number: number;
  kind: string;
  area_m2: number | null;
}
function obstaclesOf(field: FieldFull): Obstacle[] {
  return field.shapes.features
    .filter(({ properties }) => properties['kind'] !== 'field' && typeof properties['number'] === 'number')
    .map(({ properties }) => ({
      number: properties['number'] as number,
      kind: String(properties['kind']),
      area_m2: typeof properties['area_m2'] === 'number' ? properties['area_m2'] : null,
    }));
}

function Obstacles({ field }: { field: FieldFull }) {
  const list = obstaclesOf(field);
  if (list.length === 0) return null;
  return (
    <Expander title={t`Obstacles, as numbered on the map (${list.length})`}>
      <ul class="plain">
        {list.map(({ number, kind, area_m2 }) => (
          <li key={number} class="between">
            <span>
              {number} · {kind === 'passable' ? t`passable` : t`obstacle`}
              {area_m2 !== null && ` · ${squareMetres(area_m2)}`}
            </span>
            <Button kind="quiet" aria-label={t`Change obstacle ${number}`}
              onClick={() => changeObstacle(field, number, kind)}>{t`Change`}</Button>
            <Button kind="quiet" aria-label={t`Remove obstacle ${number}`} onClick={() => void attempt(() => changeField({ remove: [number] }))}>{t`Remove`}</Button>
          </li>
        ))}
      </ul>
    </Expander>
  );
}
