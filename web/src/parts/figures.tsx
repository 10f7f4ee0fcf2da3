export interface Figure {
  label: string;
  value: string;
  change?: string | undefined;
  /** Is the change for the better? */
  better?: boolean | undefined;
  /** More about the value. */
  note?: string | undefined;
  tone?: 'overlap' | 'uncovered' | 'covered';
}
export const Figures = ({ list, label }: { list: Figure[]; label: string }) => (
  <dl class="figures" aria-label={label}>
    {list.map(({ label: name, value, change, better, note, tone }) => (
      <div key={name} class={tone ?? ''}>
        <dt>{name}</dt>
        <dd>
          <span class="value">{value}</span>
          {note && <span class="sub">{note}</span>}
          {change && <span class={`change ${better === undefined ? '' : better ? 'better' : 'worse'}`}>{change}</span>}
        </dd>
      </div>
    ))}
  </dl>
);
