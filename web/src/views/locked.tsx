import { useState } from 'preact/hooks';
import { api } from '../api/client';
import { start } from '../start';
import { attempt } from '../state/notices';

/** The server wants its token. */
export function Locked() {
  const [token, setToken] = useState('');
  const enter = async () => {
    await api.session(token.trim());
    await start();
  };
  return (
    <section aria-labelledby="locked-title">
      <h2 id="locked-title">This page is locked</h2>
      <p>Type the token that tramline printed with its address, or open the whole address with “#token=…” at its end.</p>
      <form onSubmit={(event) => { event.preventDefault(); void attempt(enter); }}>
        <label class="field">
          <span class="label">Token</span>
          <input type="password" autocomplete="off" value={token} onInput={(event) => setToken(event.currentTarget.value)} />
        </label>
        <button type="submit" class="button main" disabled={token.trim() === ''}>Open the page</button>
      </form>
    </section>
  );
}
