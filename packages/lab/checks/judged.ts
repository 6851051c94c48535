import type { Kind } from './kind.ts'

/** After the project's last race both questions have an answer; every answer is one. */
export const judged: Kind<object> = {
  needs: [],
  lacks: ['not'],
  begin: () => ({}),
  observe: (_check, { raced }) => raced?.trust !== undefined && raced.explain !== undefined,
  missing: () => ({ what: 'not', facts: {} }),
}
