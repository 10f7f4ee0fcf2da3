import { useState } from 'preact/hooks';
import { attempt } from '../actions/notices';
import { unlock } from '../actions/start';
import { t } from '../words';

/** The server wants its token. */
export function Locked() {
  const [token, setToken] = useState('');
  return (
    <section aria-labelledby="locked-title">
      <h2 id="locked-title">{t`This page is locked`}</h2>
      <p>{t`Type the token that tramline printed with its address, or open that whole address, which ends with “#token=…”.`}</p>
      <form onSubmit={(event) => { event.preventDefault(); void attempt(() => unlock(token.trim())); }}>
        <label class="field">
          <span class="label">{t`Token`}</span>
          <input type="password" autocomplete="off" value={token} onInput={(event) => setToken(event.currentTarget.value)} />
        </label>
        <button type="submit" class="button main" disabled={token.trim() === ''}>{t`Open the page`}</button>
      </form>
    </section>
  );
}
