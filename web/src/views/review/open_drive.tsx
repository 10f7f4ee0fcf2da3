import { useState } from 'preact/hooks';
import { evaluateAgain, renameDrive } from '../../actions/drives';
import { attempt } from '../../actions/notices';
import { driveFile } from '../../api/addresses';
import type { Compared, DriveFull, DriveOptions, HeadingReading } from '../../api/types';
import { count, hectares, hours, length, metres, percent, plural, rate, sentence, squareMetres, width } from '../../format';
import { Button } from '../../parts/button';
import { Expander } from '../../parts/expander';
import { Figures } from '../../parts/figures';
import { Icon } from '../../parts/icon';
import { TitleField } from '../../parts/title_field';
import { Gaps } from './gaps';
import { meshFigures, ReplayBar } from './replay_bar';
import { WorkForm } from './work_form';
import { told } from '../../program_words';
import { t } from '../../words';

export function OpenDrive({ drive }: { drive: DriveFull }) {
  const s = drive.summary;
  const inside = s.covered_inside_m2 ?? s.covered_m2;
  return (
    <section class="open" aria-labelledby="drive-title">
      <h2 id="drive-title" class="unseen">{drive.name}</h2>
      <TitleField key={drive.id} label={t`Name of the drive`} value={drive.name} save={(name) => void attempt(() => renameDrive(drive.id, name))} />
      <Figures label={t`The drive in numbers`}
        list={[
          { label: t`Covered`, value: hectares(inside), tone: 'covered', ...(s.field_area_m2 ? { change: t`${percent(inside / s.field_area_m2)} of the field` } : {}) },
          { label: t`Repeated`, value: squareMetres(s.repeated_m2), tone: 'overlap', change: percent(s.repeated_rate) },
          { label: t`Missed`, value: squareMetres(s.missed_m2), tone: 'uncovered', ...(s.field_area_m2 && s.missed_m2 !== null ? { change: percent(s.missed_m2 / s.field_area_m2) } : {}) },
          ...(s.not_recorded_m2 ? [{ label: t`Not recorded`, value: squareMetres(s.not_recorded_m2) }] : []),
          { label: t`Time at work`, value: hours(s.worked_hours), change: rate(s.ha_per_hour) },
          { label: t`Outside the field`, value: squareMetres(s.outside_m2) },
          { label: t`Width`, value: width(s.width_m), change: t`${count(s.fixes_used)} fixes` },
          ...meshFigures(s.meshes),
        ]} />
      <WrongHeadings drive={drive} />
      <ReplayBar drive={drive} />
      {drive.gaps.length > 0 && <Gaps drive={drive} />}
      {drive.compared && <PlannedDone compared={drive.compared} />}
      <WorkAgain key={`again ${drive.id}`} drive={drive} />
      <Remarks drive={drive} />
      <DriveFiles id={drive.id} />
    </section>
  );
}

const READINGS: Record<HeadingReading, string> = {
  compass: t`Read them clockwise from north`,
  math: t`Read them anticlockwise from east`,
  'from-track': t`Take headings from the positions`,
};

/** Headings that cannot be right make every other figure wrong: the user is told before anything else. */
function WrongHeadings({ drive }: { drive: DriveFull }) {
  const found = drive.summary.headings;
  if (!found) return null;
  return (
    <div class="notice error" role="alert">
      <div class="grow">
        <p>
          {t`The headings in the log contradict the way driven: ${count(found.off)} of ${count(found.steps)} steps (${percent(found.share)}) are more than 45° off, first at record ${count(found.first.record)}.`}
          {found.better === 'from-track' ? t` No reading of the angles fits.` : t` Read otherwise, all but ${count(found.better_off)} agree.`}
        </p>
        <div class="row">
          <Button onClick={() => void attempt(() => evaluateAgain(drive, { ...drive.options, headings: found.better }))}>{READINGS[found.better]}</Button>
        </div>
      </div>
    </div>
  );
}

function WorkAgain({ drive }: { drive: DriveFull }) {
  const [options, setOptions] = useState<DriveOptions>(drive.options);
  return (
    <>
      <WorkForm options={options} change={setOptions} />
      {options !== drive.options && <Button onClick={() => void attempt(() => evaluateAgain(drive, options))}>{t`Work it out again`}</Button>}
    </>
  );
}

const PlannedDone = ({ compared: c }: { compared: Compared }) => (
  <>
    <h3>{t`Planned against done`}</h3>
    <table class="differences">
      <tbody>
        <tr><th scope="row">{t`Planned land`}</th><td>{hectares(c.planned_m2)}</td></tr>
        <tr><th scope="row">{t`Planned, not worked`}</th><td>{squareMetres(c.planned_missed_m2)}</td></tr>
        <tr><th scope="row">{t`Worked, not planned`}</th><td>{squareMetres(c.unplanned_m2)}</td></tr>
        {c.followed === false && <tr><th scope="row">{t`The plan was not followed`}</th><td>{c.median_angle_deg != null ? t`direction off by ${Math.round(c.median_angle_deg)}°` : ''}</td></tr>}
        <tr><th scope="row">{t`Driven along tracks`}</th><td>{length(c.along_tracks_m)}</td></tr>
        <tr><th scope="row">{t`Driven beside tracks`}</th><td>{length(c.beside_tracks_m)}</td></tr>
        <tr><th scope="row">{t`Distance from the track, mean`}</th><td>{metres(c.deviation_mean_m)}</td></tr>
        <tr><th scope="row">{t`Distance from the track, most`}</th><td>{metres(c.deviation_most_m)}</td></tr>
      </tbody>
    </table>
  </>
);

function Remarks({ drive }: { drive: DriveFull }) {
  const { warnings = [], skipped_count = 0 } = drive.summary;
  if (warnings.length === 0 && skipped_count === 0) return null;
  return (
    <Expander title={t`Remarks on the log`}>
      <ul class="plain">
        {skipped_count > 0 && <li>{t`${plural(skipped_count, 'record')} could not be used.`}</li>}
        {warnings.map((warning, i) => <li key={i}>{sentence(told(warning))}</li>)}
      </ul>
    </Expander>
  );
}

const FILES = [
  { format: 'gpkg', name: 'GeoPackage' },
  { format: 'png', name: t`Picture` },
  { format: 'svg', name: t`Drawing` },
  { format: 'pdf', name: t`Sheet` },
  { format: 'log', name: t`Log` },
];
const DriveFiles = ({ id }: { id: string }) => (
  <>
    <h3>{t`Download`}</h3>
    <ul class="files short">
      {FILES.map(({ format, name }) => (
        <li key={format}><a class="file" href={driveFile(id, format)} download><Icon name="down" /><strong>{name}</strong></a></li>
      ))}
    </ul>
  </>
);
