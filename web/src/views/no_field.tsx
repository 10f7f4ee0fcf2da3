import { show } from '../actions/session';
import { Button } from '../parts/button';

/** What a view shows that needs an open field. */
export function NoField() {
  return (
    <section>
      <p>Open a field first: choose a file, or draw one.</p>
      <Button kind="main" onClick={() => show('fields')}>Go to Fields</Button>
    </section>
  );
}
