// How deep the headland is along each side of the field: the room that turns there have.
import type { HeadlandSide } from '../../../api/types';
import { count, degrees, length, plural } from '../../../format';
import { Expander } from '../../../parts/expander';
import { t } from '../../../words';

const LISTED = 6;

const depth = ({ passes, depth_m }: HeadlandSide) =>
  passes === 0 ? t`none` : t`${plural(passes, 'pass', 'passes')}, ${length(depth_m)}`;
const name = ({ length_m, bearing_deg }: HeadlandSide) =>
  bearing_deg === null ? t`${length(length_m)}, all round` : t`${length(length_m)}, towards ${degrees(bearing_deg)}`;

export function HeadlandDepths({ sides }: { sides: HeadlandSide[] }) {
  if (sides.length === 0) return null;
  return (
    <Expander title={t`Headland along each side`}>
      <table class="legs">
        <thead><tr><th>{t`Side of the field`}</th><th>{t`Headland`}</th></tr></thead>
        <tbody>
          {sides.slice(0, LISTED).map((side, i) => <tr key={i}><th scope="row">{name(side)}</th><td>{depth(side)}</td></tr>)}
        </tbody>
      </table>
      {sides.length > LISTED && <p class="hint">{t`And ${count(sides.length - LISTED)} shorter ones.`}</p>}
    </Expander>
  );
}
