// Which view is open, and in which theme.
import { language, LANGUAGE_KEY, type Language } from '../words';
import { session, type View } from '../state/session';
import { dark, looksLike, THEME_KEY, type Theme } from '../state/theme';

/** A view begins at its top. */
export function show(view: View): void {
  if (view === session.get().view) return;
  session.set({ view });
  const toTop = () => {
    document.getElementById('panel')?.scrollTo(0, 0);
    scrollTo(0, 0);
  };
  // Before and after it is drawn. A frame later a quick hand may have gone on from there already.
  toTop();
  queueMicrotask(toTop);
}

export function applyTheme(): void {
  document.documentElement.dataset['theme'] = looksLike(session.get().theme);
}
export function setTheme(theme: Theme): void {
  localStorage.setItem(THEME_KEY, theme);
  session.set({ theme });
  applyTheme();
}
/** Words are looked up once, when the page is loaded: it is loaded anew, and opens what is open now. */
export function setLanguage(chosen: Language): void {
  if (chosen === language) return;
  localStorage.setItem(LANGUAGE_KEY, chosen);
  location.reload();
}

dark.addEventListener('change', () => {
  if (session.get().theme !== 'auto') return;
  applyTheme();
  session.set({ theme: 'auto' });
});
