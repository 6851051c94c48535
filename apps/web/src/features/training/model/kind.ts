import type { Practice } from './practice.svelte.ts'

/** Does it practise by cross-entropy: do its outputs share 100? */
export const sharesPractice = ({ brain }: Pick<Practice, 'brain'>): boolean => {
  const outputs = brain?.layers.at(-1) ?? []
  return outputs.length > 0 && outputs.every(({ activation }) => activation === 'softmax')
}
