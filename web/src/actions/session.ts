// Which view is open, and in which theme.
import { dark, isNight, session, THEME_KEY, type Theme, type View } from '../state/session';

export const show = (view: View) => session.set({ view });

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
