// Of a plan for gaps: whether it pays to work them.
import type { Explain } from '../../../api/types';
import { money, squareMetres } from '../../../format';
import { t } from '../../../words';

export function RepairCosts({ repair: r }: { repair: NonNullable<Explain['repair']> }) {
  const saved = r.cost_if_left - r.cost_of_passes - r.cost_after;
  return (
    <section aria-labelledby="repair-title">
      <h2 id="repair-title">{t`What the repair costs`}</h2>
      <table class="differences">
        <tbody>
          <tr><th scope="row">{t`The gaps left as they are`}</th><td>{squareMetres(r.missed_before_m2)}</td><td>{money(r.cost_if_left)}</td></tr>
          <tr><th scope="row">{t`Passes that work them`}</th><td /><td>{money(r.cost_of_passes)}</td></tr>
          <tr><th scope="row">{t`Gaps that stay`}</th><td>{squareMetres(r.missed_after_m2)}</td><td>{money(r.cost_after)}</td></tr>
          <tr class="total"><th scope="row">{saved >= 0 ? t`Saved` : t`Lost`}</th><td /><td>{money(Math.abs(saved))}</td></tr>
        </tbody>
      </table>
    </section>
  );
}
