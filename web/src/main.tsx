import { render } from 'preact';
import { App } from './app';
import { comeBack, start } from './start';
import { complain } from './state/notices';
import { planAtChanges } from './state/plans';
import { applyTheme, watchServer } from './state/session';

applyTheme();
render(<App />, document.getElementById('page')!);
// A file that misses its place must not make the browser leave the page.
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  complain('Drop the file on the dashed place, or choose it with the button there.');
});
watchServer(() => void comeBack());
planAtChanges();
void start();
