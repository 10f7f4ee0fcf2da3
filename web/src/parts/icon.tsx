const PATHS = {
  close: 'M5 5 15 15M15 5 5 15',
  plus: 'M10 4V16M4 10H16',
  minus: 'M4 10H16',
  fit: 'M4 8V4H8M12 4H16V8M16 12V16H12M8 16H4V12',
  play: 'M6 4 16 10 6 16Z',
  pause: 'M6 4V16M14 4V16',
  sun: 'M10 6.5a3.5 3.5 0 1 0 0 7a3.5 3.5 0 1 0 0-7M10 1.5V3.5M10 16.5V18.5M1.5 10H3.5M16.5 10H18.5M4 4 5.4 5.4M14.6 14.6 16 16M16 4 14.6 5.4M5.4 14.6 4 16',
  moon: 'M16.5 12A7 7 0 1 1 8 3.5A5.5 5.5 0 0 0 16.5 12Z',
  field: 'M3 6 9 3 17 5 15 16 5 17Z',
  plan: 'M4 17V7A3 3 0 0 1 10 7V13A3 3 0 0 0 16 13V3',
  compare: 'M3 17V3M3 17H17M6.5 6.5h.01M9 11h.01M14 13.5h.01',
  review: 'M10 3A7 7 0 1 0 17 10M10 6V10L13 12',
  bin: 'M4 6H16M8 6V4H12V6M6 6 7 17H13L14 6',
  settings: 'M3 6H9M13 6H17M3 14H7M11 14H17M11 4V8M9 12V16',
  down: 'M10 3V13M5.5 9 10 13.5 14.5 9M4 17H16',
} as const;
export type IconName = keyof typeof PATHS;

export const Icon = ({ name }: { name: IconName }) => (
  <svg class="icon" viewBox="0 0 20 20" aria-hidden="true" fill={name === 'play' ? 'currentColor' : 'none'} stroke="currentColor"
    stroke-width={name === 'compare' ? 2.2 : 1.8} stroke-linecap="round" stroke-linejoin="round">
    <path d={PATHS[name]} />
  </svg>
);
