import type { Helpers } from '../helpers.ts'

/** Driving by a table over buckets of what is sensed: packages/learning/q-senses/model.md. */
export const trying: Helpers = {
  bucket: () => ['(reading, edges):', 'return len([edge for edge in edges if reading >= edge])'],
  best_action: ({ call }) => [
    '(values):',
    'most = max(values)',
    'best = [place for place in range(len(values)) if values[place] == most]',
    `return best[0] if len(best) == 1 else ${call('pick')}(best)`,
  ],
}
