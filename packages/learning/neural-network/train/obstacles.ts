import type { Brain } from '../types.ts'
import { sharesIn } from './layout.ts'
import type { PracticeData } from './types.ts'

/**
 * What keeps a network from practising at all. `noLinks`: there is nothing to change · `threshold`: every path leads through
 * one, and its step has no slope · `softmax`: outputs share 100 all together or not at all · `none`: of outputs that share a row
 * chooses exactly one; `row`, of the practised ones or else of those held back, chooses none or several.
 */
export type Obstacle =
  | { readonly kind: 'noLinks' | 'softmax' }
  | { readonly kind: 'threshold'; readonly neurons: readonly string[] }
  | { readonly kind: 'none'; readonly row: number }

/** The first obstacle; null: it can practise. */
export function obstacleTo(data: PracticeData): Obstacle | null {
  const { layers } = data
  if (layers.length < 2 || layers.some((layer) => layer.length === 0)) return { kind: 'noLinks' }
  const thresholds = blocking(layers)
  if (thresholds.length > 0) return { kind: 'threshold', neurons: thresholds }
  if (!sharesIn(layers)) {
    const some = layers
      .slice(1)
      .flat()
      .some(({ activation }) => activation === 'softmax')
    return some ? { kind: 'softmax' } : null
  }
  const row = rowWithoutOne(data)
  return row === null ? null : { kind: 'none', row }
}

/** Neurons of the first layer through which no slope leads. */
function blocking(layers: Brain['layers']): readonly string[] {
  const blocked = layers.slice(1).find((layer) => layer.every(({ activation }) => activation === 'threshold'))
  return (blocked ?? []).map(({ id }) => id)
}

/** Targets of cross-entropy are 1 for the one that is chosen, 0 for all others. */
function rowWithoutOne({ layers, practised, kept }: PracticeData): number | null {
  const width = layers.at(-1)!.length
  const isOne = (targets: Float64Array) =>
    targets.every((value) => value === 0 || value === 1) && targets.reduce((a, b) => a + b, 0) === 1
  for (const { count, targets } of [practised, kept])
    for (let row = 0; row < count; row++)
      if (!isOne(targets.subarray(row * width, (row + 1) * width))) return row
  return null
}
