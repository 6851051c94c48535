import { withWords } from '#words/message.ts'

/** What draws a question about Bo outside of the learning materials. */
export const loadAskedPicture = async () =>
  (
    await withWords(import('./AskedPicture.svelte'), [
      'materials',
      'network',
      'q-learning',
      'sorting',
      'worlds',
      'reward-zoo',
    ])
  ).default
