import type { Brain, Weights } from '@botgarten/learning/neural-network'
import type { NetworkOutline } from '@botgarten/programs'
import type { Point, Size } from '#drawing/points.ts'
import { level } from '../level.svelte.ts'
import type { Neuron } from '../neurons.ts'
import { dressed, hiddenColumn } from './columns.ts'
import { layoutDeep, nearTo, settleDeep } from './layout.ts'

/** Keeps resting knobs apart. */
export const settle = settleDeep

/** All neurons from the inputs to the outputs, with what they say of themselves. */
export const columnsOf = (
  net: NetworkOutline,
  [inputs, outputs]: readonly [readonly Neuron[], readonly Neuron[]],
  brain: Brain | undefined,
  weights: Weights,
): Neuron[][] =>
  [inputs, ...net.hidden.map(hiddenColumn), outputs].map((column) =>
    column.map((neuron) => dressed(neuron, brain, weights)),
  )

/** Where a network with layers of so many neurons is drawn. */
export const layoutOf = (room: Size, counts: readonly number[]) => layoutDeep(room, counts, level.deep)

/** How much of it is drawn. `at`: what is seen, from the stage's corner. */
export function seesOf(room: Size, counts: readonly number[], at: Point) {
  const links = counts.slice(1).reduce((sum, count, k) => sum + count * counts[k]!, 0)
  return nearTo(room, at, links)
}
