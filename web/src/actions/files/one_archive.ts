// Files as one archive; loaded when it is needed, and no more of the library than this.
import { zipSync } from 'fflate';

export const zipped = (entries: Record<string, Uint8Array>): Uint8Array<ArrayBuffer> => zipSync(entries, { level: 1 }) as Uint8Array<ArrayBuffer>;
