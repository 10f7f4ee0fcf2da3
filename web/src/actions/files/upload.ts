// A file on its way to the server, and what the page says while it waits.
import { api } from '../../api/client';
import { ApiError } from '../../api/errors';
import type { Upload } from '../../api/types';
import { megabytes } from '../../format';
import { fields } from '../../state/fields';
import { session } from '../../state/session';
import { t } from '../../words';

/** While `what` is being done the page says so. */
export async function busy<R>(what: string, action: () => Promise<R>): Promise<R> {
  fields.set({ busy: what });
  try {
    return await action();
  } finally {
    fields.set({ busy: null });
  }
}

function assertSize(file: File): void {
  const limit = session.get().info?.limits.upload_bytes;
  if (limit !== undefined && file.size > limit) {
    throw new ApiError(
      'too_large',
      t`${file.name} is ${megabytes(file.size)} large, but the server takes at most ${megabytes(limit)}. Split it into smaller files, or zip it.`,
      413,
    );
  }
  if (file.size === 0) throw new ApiError('bad_input', t`${file.name} is empty. Choose another file.`, 400);
}

/** Files that belong together, such as .shp, .shx and .dbf, go as one archive. */
export async function asOne(files: File[]): Promise<File> {
  const [first] = files;
  if (files.length === 1 && first) return first;
  const { zipped } = await import('./one_archive');
  const entries = await Promise.all(files.map(async (file) => [file.name, new Uint8Array(await file.arrayBuffer())] as const));
  const main = files.find(({ name }) => /\.(shp|xml|gml|tab|mif)$/i.test(name)) ?? files[0]!;
  return new File([zipped(Object.fromEntries(entries))], main.name.replace(/\.[^.]+$/, '.zip'));
}

/** Sends a file, unless its size already says that the server cannot take it. */
export async function uploadFile(file: File): Promise<Upload> {
  assertSize(file);
  return busy(t`Reading ${file.name} …`, () => api.upload(file));
}
