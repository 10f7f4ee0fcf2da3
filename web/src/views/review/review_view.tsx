import { cancelReview, takeLogFile } from '../../actions/drives';
import { attempt } from '../../actions/notices';
import { DropZone } from '../../parts/drop_zone';
import { Progress } from '../../parts/progress';
import { fields } from '../../state/fields';
import { replay } from '../../state/replay';
import { review } from '../../state/review';
import { useStore } from '../../state/store';
import { DriveList } from './drive_list';
import { LiveFeed, StartFeed } from './live_feed';
import { LogForm } from './log_form';
import { OpenDrive } from './open_drive';
import { t } from '../../words';

export function ReviewView() {
  const busy = useStore(fields, (value) => value.busy);
  const upload = useStore(review, (value) => value.upload);
  const drive = useStore(review, (value) => value.drive);
  const job = useStore(review, (value) => value.job);
  const feed = useStore(replay, (value) => value.of === 'feed');
  if (feed) return <LiveFeed />;
  const progress = job && <Progress job={job} title={t`Working out the areas`} cancel={() => void attempt(cancelReview)} />;
  // The form stays as it was filled in, for when the job fails or is cancelled.
  if (upload) {
    return (
      <>
        {progress}
        <div hidden={job !== null}><LogForm key={upload.id} upload={upload} /></div>
      </>
    );
  }
  if (progress) return progress;
  return (
    <>
      {drive && <OpenDrive drive={drive} />}
      <section aria-label={t`Bring a log`}>
        <DropZone label={t`Choose the log of a machine`} hint={t`or drop it here: CSV, NMEA, GPX, ISOXML (zipped)`} busy={busy}
          take={(files) => void attempt(() => takeLogFile(files))} />
        <StartFeed />
      </section>
      <DriveList />
    </>
  );
}
