import type { Kind } from './kind.ts'

/** The robot drives by a table that it has learned by trying. */
export const tried: Kind<object> = {
  needs: [],
  lacks: ['not'],
  begin: () => ({}),
  observe: (_check, { table }) => table !== null,
  missing: () => ({ what: 'not', facts: {} }),
}
