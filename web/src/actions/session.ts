// Which view is open, and in which theme.
import { dark, isNight, session, THEME_KEY, type Theme, type View } from '../state/session';

/** A view begins at its top. */
export function show(view: View): void {
  if (view === session.get().view) return;
  session.set({ view });
  requestAnimationFrame(() => {
    document.getElementById('panel')?.scrollTo(0, 0);
    scrollTo(0, 0);
  });
}

export function applyTheme(): void {
  document.documentElement.dataset['theme'] = isNight() ? 'night' : 'day';
}
export function setTheme(theme: Theme): void {
  localStorage.setItem(THEME_KEY, theme);
  session.set({ theme });
  applyTheme();
}
dark.addEventListener('change', () => {
  if (session.get().theme !== 'auto') return;
  applyTheme();
  session.set({ theme: 'auto' });
});
