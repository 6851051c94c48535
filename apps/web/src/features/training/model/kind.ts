import { rightIn } from '@botgarten/learning/neural-network/examples'
import { choiceIn } from '@botgarten/programs/examples'
import type { Practice } from './practice.svelte.ts'

/** Does it practise by cross-entropy: do its outputs share 100? */
export const sharesPractice = ({ brain }: Pick<Practice, 'brain'>): boolean => {
  const outputs = brain?.layers.at(-1) ?? []
  return outputs.length > 0 && outputs.every(({ activation }) => activation === 'softmax')
}

/** So many examples are counted while knobs move; more of them only when they rest. */
const mostCounted = 500

/**
 * How many examples lamps or words get right with the knobs as they are: of those that are kept back, else of those that are
 * practised. Null: outputs are measured by how far they are off, or there are too many to count while it practises.
 */
export function rightNow({ net, layers, prepared, knobs, isGoing }: Practice) {
  const choice = net && choiceIn(net)
  if (!choice || !prepared) return null
  const { kept, practised } = prepared
  const pairs = kept.length > 0 ? kept : practised
  if (pairs.length === 0 || (isGoing && pairs.length > mostCounted)) return null
  return { right: rightIn(layers, knobs.weights, pairs, choice), of: pairs.length }
}
