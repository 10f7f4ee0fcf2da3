// How a thing is drawn on the map, in small.
export interface Mark {
  colour: string;
  form: 'area' | 'line' | 'dashed' | 'hatch';
}
export const MarkOf = ({ mark }: { mark: Mark }) => (
  <svg class="mark" viewBox="0 0 20 20" aria-hidden="true">
    {mark.form === 'area' && <rect x="2" y="3" width="16" height="14" rx="2" fill={mark.colour} stroke="currentColor" stroke-opacity="0.4" />}
    {mark.form === 'hatch' && <path d="M2 12 8 3M5 17 15 3M12 17 18 8" stroke={mark.colour} stroke-width="2" />}
    {mark.form === 'line' && <path d="M1 10H19" stroke={mark.colour} stroke-width="3" />}
    {mark.form === 'dashed' && <path d="M1 10H19" stroke={mark.colour} stroke-width="3" stroke-dasharray="5 3" />}
  </svg>
);
