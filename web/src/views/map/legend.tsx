// What is on the map, over it where there is room and below it where there is none.
import { useState } from 'preact/hooks';
import { plans } from '../../state/plans';
import { replay } from '../../state/replay';
import { review } from '../../state/review';
import { session } from '../../state/session';
import { useStore } from '../../state/store';
import { DriveLayers } from './drive_layer_list';
import { LayerList } from './plan_layer_list';
import { t } from '../../words';

/** Phones and tablets keep their map free. */
const narrow = matchMedia('(max-width: 1100px)');

export function Legend() {
  const view = useStore(session, (value) => value.view);
  const plan = useStore(plans, (value) => value.open !== null);
  const drive = useStore(review, (value) => value.drive);
  const moving = useStore(replay, (value) => value.of !== null);
  const [open, setOpen] = useState(!narrow.matches);
  const list = view === 'plan' || view === 'compare' ? plan && <LayerList /> : view === 'review' && drive && !moving ? <DriveLayers drive={drive} /> : null;
  if (!list) return null;
  return (
    <aside class="unboxed" aria-label={t`Legend`}>
      <details class="legend" open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
        <summary>{t`On the map`}</summary>
        {list}
      </details>
    </aside>
  );
}
