// The theme that was chosen, and the one to show: the frame of the page asks before everything else is there.
export type Theme = 'auto' | 'day' | 'night';

/** What the browser keeps a chosen theme under. */
export const THEME_KEY = 'tramline-theme';
export const remembered = (): Theme => {
  const theme = localStorage.getItem(THEME_KEY);
  return theme === 'day' || theme === 'night' ? theme : 'auto';
};

export const dark = matchMedia('(prefers-color-scheme: dark)');
export const looksLike = (theme: Theme): 'day' | 'night' => (theme === 'night' || (theme === 'auto' && dark.matches) ? 'night' : 'day');
