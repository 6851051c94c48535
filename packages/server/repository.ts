import { join } from 'node:path'

/** A path below the folder of the product. */
export const inRepository = (...parts: readonly string[]): string =>
  join(import.meta.dirname, '..', '..', ...parts)
