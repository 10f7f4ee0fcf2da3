import { show } from '../actions/session';
import { Button } from '../parts/button';
import { t } from '../words';

/** What a view shows that needs an open field. */
export function NoField() {
  return (
    <section>
      <p>{t`Open a field first: choose a file, or draw one.`}</p>
      <Button kind="main" onClick={() => show('fields')}>{t`Go to Fields`}</Button>
    </section>
  );
}
