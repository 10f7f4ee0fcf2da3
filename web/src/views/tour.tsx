// One sentence on the view that is open, and the way to the next.
import { goToStop } from '../actions/example';
import { Button } from '../parts/button';
import { useStore } from '../state/store';
import { STOPS, tour } from '../state/tour';
import { t } from '../words';

export function Tour() {
  const stop = useStore(tour, (value) => value.stop);
  const at = stop === null ? null : STOPS[stop];
  if (!at || stop === null) return null;
  const last = stop === STOPS.length - 1;
  return (
    <section class="open" aria-label={t`Tour`}>
      <p role="status">{t`${stop + 1} of ${STOPS.length}. ${at.text}`}</p>
      <div class="row">
        <Button kind="main" onClick={() => goToStop(last ? null : stop + 1)}>{last ? t`Done` : t`Next`}</Button>
        {!last && <Button kind="quiet" onClick={() => goToStop(null)}>{t`End the tour`}</Button>}
      </div>
    </section>
  );
}
