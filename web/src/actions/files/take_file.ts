// A file of a plan to take away, or the reason why there is none.
import { failure } from '../../api/client';
import { ApiError, AWAY } from '../../api/errors';

/** Under the name that the server gives it. */
function nameIn(response: Response): string {
  const header = response.headers.get('Content-Disposition') ?? '';
  const coded = /filename\*=UTF-8''([^;]+)/.exec(header)?.[1];
  return coded ? decodeURIComponent(coded) : (/filename="([^"]+)"/.exec(header)?.[1] ?? 'plan');
}

export async function takeFile(address: string): Promise<string> {
  const response = await fetch(address, { credentials: 'same-origin' }).catch(() => {
    throw new ApiError('away', AWAY, 0);
  });
  if (!response.ok) throw await failure(response);
  const name = nameIn(response);
  const link = document.createElement('a');
  link.href = URL.createObjectURL(await response.blob());
  link.download = name;
  link.click();
  // The browser has begun to read it by then.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  return name;
}
