// Large figures for the cab: how far off the line, how fast, and whether at work.
import type { FixQuality } from '../../api/types';
import { metres, speed } from '../../format';
import { offLine } from '../../map/guidance';
import { plans } from '../../state/plans';
import { replay } from '../../state/replay';
import { useStore } from '../../state/store';
import { t } from '../../words';

/** How good a position is, and about how near it is to the truth. */
const QUALITIES: Record<FixQuality, { short: string; about: string }> = {
  'rtk fixed': { short: t`RTK`, about: t`to about 2 cm` },
  'rtk float': { short: t`RTK float`, about: t`to some decimetres` },
  differential: { short: t`DGPS`, about: t`to about a metre` },
  single: { short: t`GPS`, about: t`to some metres` },
  estimated: { short: t`Guessed`, about: t`without satellites` },
};

export function CabFigures() {
  const { at, heading_deg, speed_mps, working, quality } = useStore(replay, (value) => value);
  const plan = useStore(plans, (value) => value.open);
  const shapes = useStore(plans, (value) => value.shapes);
  if (!at) return null;
  const off = plan && heading_deg !== null ? offLine([shapes['tracks'], shapes['headland_passes']], at, heading_deg, plan.summary.width_m) : null;
  const side = off === null ? '' : Math.abs(off.right_m) < 0.005 ? t`on the line` : off.right_m > 0 ? t`to the right` : t`to the left`;
  return (
    <dl class="cab" aria-label={t`In the cab`}>
      <div>
        <dt>{off?.order ? t`Off track ${off.order}` : t`Off the line`}</dt>
        <dd>{off === null ? '–' : metres(Math.abs(off.right_m))}<span class="sub">{off === null ? (plan ? t`no line near` : t`no plan open`) : side}</span></dd>
      </div>
      <div><dt>{t`Speed`}</dt><dd>{speed(speed_mps)}</dd></div>
      {quality && <div class={quality === 'rtk fixed' ? '' : 'doubtful'}><dt>{t`Position`}</dt><dd>{QUALITIES[quality].short}<span class="sub">{QUALITIES[quality].about}</span></dd></div>}
      <div><dt>{t`Work`}</dt><dd>{working ? t`on` : t`off`}</dd></div>
    </dl>
  );
}
