import type { Feature } from '#parts/feature.ts'

export { fetchBlocklyWords } from './view/blockly-words.ts'
export * as packs from './model/packs.ts'
export type { default as EditorPane } from './view/Editor.svelte'

/** The blocks: the heaviest part of the lab, which comes once the screen stands. Packs of blocks come when a program needs them. */
export const editor = {
  id: 'editor',
  words: [],
  load: () => import('./lazy.ts'),
} satisfies Feature
