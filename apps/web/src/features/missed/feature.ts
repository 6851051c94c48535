import type { Feature } from '#parts/feature.ts'

/** What a run has missed, in one sentence. */
export const missed = {
  id: 'missed',
  words: ['missed'],
  load: () => import('./MissedNote.svelte'),
} satisfies Feature
