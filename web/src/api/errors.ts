// What goes wrong with a request, as one sentence for the user.
import { t } from '../words';

export class ApiError extends Error {
  constructor(
    readonly code: string,
    message: string,
    readonly status: number,
  ) {
    super(message);
  }
  /** The server could not be reached at all. */
  get away(): boolean {
    return this.status === 0;
  }
}

export const AWAY = t`The tramline server does not answer. Start it again with “tramline serve”; this page then reconnects by itself.`;
