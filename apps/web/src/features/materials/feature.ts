import type { Feature } from '#parts/feature.ts'

export { default as ItemPage } from './ItemPage.svelte'
export * as library from './library.ts'
export { choiceIn, queryOf, type Choice } from './library/choice.ts'
export { default as Library } from './library/Library.svelte'
export { default as Material } from './Material.svelte'
export { default as MaterialsBar } from './MaterialsBar.svelte'
export { default as PackPage } from './pack/PackPage.svelte'
export { ownPack, packIds, packNamed } from './pack/packs.ts'
export { default as PrintPage } from './print/PrintPage.svelte'
export { default as Questions } from './questions/Questions.svelte'
export { loadAskedPicture } from './questions/asked-picture.ts'
export { default as Deck } from './slides/Deck.svelte'

/** Cards, lessons, slides and sheets to read, to show and to print. What draws with the lab's own hands comes later. */
export const materials = {
  id: 'materials',
  words: ['materials', 'network', 'q-learning', 'sorting', 'worlds', 'reward-zoo'],
  route: 'materials',
  load: () => import('./lazy.ts'),
} satisfies Feature
