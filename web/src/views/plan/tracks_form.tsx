// Tracks along an edge of the field, or along a line that is drawn.
import { drawFor, pickEdge } from '../../actions/drawing';
import { edit } from '../../actions/hand';
import type { Place } from '../../api/types';
import { degrees, length } from '../../format';
import { openEdges } from '../../map/edges';
import { bearing, distance } from '../../metres';
import { Button } from '../../parts/button';
import { Choice, Select } from '../../parts/choice';
import { form, type Shape } from '../../state/plan_form';
import { useStore } from '../../state/store';
import { t } from '../../words';

const SHAPES: { value: Shape; label: string }[] = [
  { value: 'straight', label: t`Straight` },
  { value: 'curved', label: t`Curved` },
  { value: 'auto', label: t`Whichever costs less` },
];
const LISTED = 12;

const said = (line: Place[]) => {
  const long = line.slice(1).reduce((sum, place, i) => sum + distance(line[i]!, place), 0);
  return t`${length(long)}, towards ${degrees(bearing(line[0]!, line[line.length - 1]!))}`;
};

export function TracksForm() {
  const shape = useStore(form, (value) => value.shape);
  const line = useStore(form, (value) => value.line);
  const edges = openEdges().slice(0, LISTED);
  const picked = edges.find((edge) => edge.line === line);
  return (
    <section aria-labelledby="follow-title">
      <h2 id="follow-title">{t`Tracks`}</h2>
      <Choice label={t`Shape`} value={shape} options={SHAPES} change={(value) => form.set({ shape: value })} />
      <Select label={t`Parallel to`} value={picked ? String(picked.number) : line ? 'line' : ''}
        options={[
          { value: '', label: t`whatever costs least` },
          ...(line && !picked ? [{ value: 'line', label: t`a line, ${said(line)}` }] : []),
          ...edges.map((edge) => ({ value: String(edge.number), label: t`edge ${edge.number}: ${length(edge.length_m)}, towards ${degrees(edge.bearing_deg)}` })),
        ]}
        change={(value) => value !== 'line' && edit({ line: edges.find((edge) => String(edge.number) === value)?.line ?? null })} />
      <div class="row">
        <Button onClick={pickEdge}>{t`Pick an edge`}</Button>
        <Button onClick={() => drawFor('guide', async (geometry) => edit({ line: geometry.coordinates as Place[] }))}>{t`Draw a line`}</Button>
        {line && <Button kind="quiet" onClick={() => edit({ line: null })}>{t`Remove the line`}</Button>}
      </div>
    </section>
  );
}
