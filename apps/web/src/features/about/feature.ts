import type { Feature } from '#parts/feature.ts'

export { fonts, licenceTexts } from './notices.ts'
export { default as Libraries } from './Libraries.svelte'
export { default as Operator } from './Operator.svelte'

/** Who runs this lab, which version it is, and whose work it stands on. */
export const about = {
  id: 'about',
  words: ['about'],
  route: 'about',
} satisfies Feature
