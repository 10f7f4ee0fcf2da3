import { render } from 'preact';
import { readAgain } from './actions/feeds';
import { keepFocus } from './actions/focus';
import { attempt, complain } from './actions/notices';
import { planAtChanges } from './actions/planning';
import { followWidth } from './actions/rates';
import { onLostFeed } from './actions/play/replay';
import { watchServer } from './actions/server';
import { applyTheme } from './actions/session';
import { comeBack, start } from './actions/start';
import { App } from './app';
import { t } from './words';

applyTheme();
// A page of a machine opens at its top, whatever was read last.
history.scrollRestoration = 'manual';
render(<App />, document.getElementById('page')!);
keepFocus();
// A file that misses its place must not make the browser leave the page.
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  complain(t`Drop the file on the dashed box, or choose it with the button there.`);
});
watchServer(() => void comeBack());
planAtChanges();
followWidth();
onLostFeed((feed) => attempt(() => readAgain(feed)).then(() => {}));
void start();
