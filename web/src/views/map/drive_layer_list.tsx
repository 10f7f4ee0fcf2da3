import { switchDriveLayer } from '../../actions/drives';
import { attempt } from '../../actions/notices';
import type { DriveFull, FeatureCollection } from '../../api/types';
import { area, hectares, length } from '../../format';
import { DAY, NIGHT } from '../../map/palette';
import { Switch } from '../../parts/switch';
import { DRIVE_LAYERS, hasLayer, review, type DriveLayer } from '../../state/review';
import { isNight, session } from '../../state/session';
import { useStore } from '../../state/store';
import { t } from '../../words';

const TITLES: Record<DriveLayer, string> = {
  covered: t`Covered`, repeated: t`Repeated`, missed: t`Missed`, not_recorded: t`Not recorded`, multiplicity: t`How often worked`, track: t`Path driven`, gaps: t`Gaps, numbered`,
};

const sum = (shapes: FeatureCollection | undefined, key: string) =>
  (shapes?.features ?? []).reduce((all, { properties }) => all + (typeof properties[key] === 'number' ? (properties[key] as number) : 0), 0);

function size(name: DriveLayer, drive: DriveFull, shapes: FeatureCollection | undefined): string {
  const s = drive.summary;
  switch (name) {
    case 'covered': return hectares(s.covered_m2);
    case 'repeated': return area(s.repeated_m2);
    case 'missed': return area(s.missed_m2);
    case 'not_recorded': return area(s.not_recorded_m2 ?? 0);
    case 'gaps': return String(drive.gaps.length);
    case 'track': return shapes ? length(sum(shapes, 'length_m')) : '';
    case 'multiplicity': return shapes ? area(sum(shapes, 'area_m2')) : '';
  }
}

export function DriveLayers({ drive }: { drive: DriveFull }) {
  const shown = useStore(review, (value) => value.shown);
  const shapes = useStore(review, (value) => value.shapes);
  useStore(session, (value) => value.theme);
  const c = isNight() ? NIGHT : DAY;
  const colour: Record<DriveLayer, string> = { covered: c.Covered, repeated: c.Overlap, missed: c.Uncovered, not_recorded: c.NotRecorded, multiplicity: c.TwiceHatch, track: c.WorkedPath, gaps: c.Uncovered };
  return (
    <div class="layers">
      {DRIVE_LAYERS.filter((name) => hasLayer(drive, name)).map((name) => (
        <Switch key={name} on={shown[name]} label={TITLES[name]} value={size(name, drive, shapes[name])}
          mark={{ colour: colour[name], form: name === 'track' ? 'line' : 'area' }}
          change={(on) => void attempt(() => switchDriveLayer(name, on))} />
      ))}
    </div>
  );
}
