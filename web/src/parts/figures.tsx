export interface Figure {
  label: string;
  value: string;
  change?: string | undefined;
  /** Is the change for the better? */
  better?: boolean | undefined;
  tone?: 'overlap' | 'uncovered' | 'covered';
}
export const Figures = ({ list, label }: { list: Figure[]; label: string }) => (
  <dl class="figures" aria-label={label}>
    {list.map(({ label: name, value, change, better, tone }) => (
      <div key={name} class={tone ?? ''}>
        <dt>{name}</dt>
        <dd>
          <span class="value">{value}</span>
          {change && <span class={`change ${better === undefined ? '' : better ? 'better' : 'worse'}`}>{change}</span>}
        </dd>
      </div>
    ))}
  </dl>
);
