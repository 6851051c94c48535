import type { Feature } from '#parts/feature.ts'

export { default as Home } from './Home.svelte'
export { bedOf, recentOf } from './home.ts'

/** The garden: all cards, the child's newest projects. */
export const home = {
  id: 'home',
  words: [],
  route: '',
} satisfies Feature
