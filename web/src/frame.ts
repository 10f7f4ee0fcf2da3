// Runs before anything is painted: the frame that index.html holds is painted in the right theme, and the page itself is worked out after that.
import { looksLike, remembered } from './state/theme';

document.documentElement.dataset['theme'] = looksLike(remembered());

const app = document.currentScript!.dataset['app']!;
function load(): void {
  const script = document.createElement('script');
  script.type = 'module';
  script.src = app;
  document.head.append(script);
}
// A page in a tab that nobody looks at has no frames: there is nothing to wait for. Else the first frame comes once the page is parsed and its
// style is there, and is painted before the time after it.
if (document.hidden) load();
else addEventListener('DOMContentLoaded', () => requestAnimationFrame(() => setTimeout(load)));
