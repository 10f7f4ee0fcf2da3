// A job from its start to its result, with progress and cancel.
import { sentence } from '../format';
import { jobEvents } from './addresses';
import { api } from './client';
import { ApiError, AWAY } from './errors';
import { openStream } from './event_stream';
import type { Job, JobResult } from './types';
import { told } from '../program_words';
import { t } from '../words';

/** What Cancel was pressed for. */
export class Cancelled extends Error {}

function outcome(job: Job): JobResult {
  if (job.state === 'cancelled') throw new Cancelled();
  if (job.state === 'failed') {
    const error = job.error;
    const message = typeof error === 'string' ? error : error?.message;
    throw new ApiError('failed', sentence(message ? told(message) : t`The job failed. Try again, or look at what the server prints.`), 422);
  }
  return job.result ?? {};
}

const over = (job: Job) => job.state === 'done' || job.state === 'failed' || job.state === 'cancelled';

/** Resolves with the result; rejects with Cancelled or an ApiError. `progress` is called with every state. */
export async function follow(job: Job, progress: (job: Job) => void): Promise<JobResult> {
  progress(job);
  if (over(job)) return outcome(job);
  const last = await new Promise<Job>((resolve, reject) => {
    const end = (state: Job) => {
      stream.close();
      resolve(state);
    };
    const stream = openStream(
      jobEvents(job.id),
      { progress: (state: Job) => (over(state) ? end(state) : progress(state)), done: end, failed: end, cancelled: end },
      () => {
        // The stream may have been shut after the last event got lost: ask once.
        api.job(job.id).then(
          (state) => (over(state) ? resolve(state) : reject(new ApiError('away', AWAY, 0))),
          reject,
        );
      },
    );
  });
  return outcome(last);
}
