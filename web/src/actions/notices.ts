// Telling the user: how an action of theirs came out, and what to do where it failed.
import { ApiError } from '../api/errors';
import { Cancelled } from '../api/jobs';
import { notices, type Notice } from '../state/notices';
import { t } from '../words';

let last = 0;
function add(kind: Notice['kind'], text: string): void {
  const others = notices.get().list.filter((notice) => notice.text !== text);
  const notice = { number: ++last, kind, text };
  notices.set({ list: [...others, notice].slice(-3) });
  if (kind === 'note') setTimeout(() => dismiss(notice.number), 8000);
}
export const note = (text: string) => add('note', text);
export const complain = (text: string) => add('error', text);
export function dismiss(number: number): void {
  notices.set({ list: notices.get().list.filter((notice) => notice.number !== number) });
}

/** Runs an action of the user; a failure becomes a notice. True if it came through. */
export async function attempt(action: () => Promise<unknown>): Promise<boolean> {
  try {
    await action();
    return true;
  } catch (error) {
    if (error instanceof Cancelled) note(t`Cancelled. Nothing was changed.`);
    else if (error instanceof ApiError) {
      if (!error.away) complain(error.message); // the banner already says that the server is away
    } else {
      console.error(error);
      complain(t`Something went wrong on this page. Reload it; what was saved is still there.`);
    }
    return false;
  }
}
