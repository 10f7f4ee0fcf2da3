// Large figures for the cab: how far off the line, how fast, and whether at work.
import { metres, speed } from '../../format';
import { offLine } from '../../map/guidance';
import { plans } from '../../state/plans';
import { replay } from '../../state/replay';
import { useStore } from '../../state/store';

export function CabFigures() {
  const { at, heading_deg, speed_mps, working } = useStore(replay, (value) => value);
  const plan = useStore(plans, (value) => value.open);
  const shapes = useStore(plans, (value) => value.shapes);
  if (!at) return null;
  const off = plan && heading_deg !== null ? offLine([shapes['tracks'], shapes['headland_passes']], at, heading_deg, plan.summary.width_m) : null;
  const side = off === null ? '' : Math.abs(off.right_m) < 0.005 ? 'on the line' : off.right_m > 0 ? 'to the right' : 'to the left';
  return (
    <dl class="cab" aria-label="In the cab">
      <div>
        <dt>{off?.order ? `Off track ${off.order}` : 'Off the line'}</dt>
        <dd>{off === null ? '–' : metres(Math.abs(off.right_m))}<span class="sub">{off === null ? (plan ? 'no line near' : 'no plan open') : side}</span></dd>
      </div>
      <div><dt>Speed</dt><dd>{speed(speed_mps)}</dd></div>
      <div><dt>Work</dt><dd>{working ? 'on' : 'off'}</dd></div>
    </dl>
  );
}
