import { drawing } from '../state/drawing';
import { fields } from '../state/fields';
import { session } from '../state/session';
import { fit } from './camera';
import { NOTHING, type LiveMap } from './live_map';

/** The open field on the map, fitted when another one is opened. */
export function followField({ map, fill, visible }: LiveMap): void {
  let shapes: unknown = null;
  let open: string | null = null;
  const sync = () => {
    const field = fields.get().open;
    if (field?.shapes !== shapes) {
      shapes = field?.shapes;
      fill('field', field?.shapes ?? NOTHING);
    }
    if (field && field.id !== open) fit(map, field.bbox);
    open = field?.id ?? null;
  };
  fields.listen(sync);
  sync();

  const numbers = () => visible(['obstacle-number'], session.get().view === 'fields' && drawing.get().purpose !== 'field');
  session.listen(numbers);
  drawing.listen(numbers);
  numbers();
}
