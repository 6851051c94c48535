import type { Feature } from '#parts/feature.ts'

export { announcedElsewhere } from './elsewhere.ts'

/** Leads from an address that is not the announced one to the one that is, and says what is still kept here. */
export const address = {
  id: 'address',
  words: ['address', 'projects'],
  load: () => import('./lazy.ts'),
} satisfies Feature
