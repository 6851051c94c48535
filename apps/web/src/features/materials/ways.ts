import { resolve } from '$app/paths'
import type { Item } from '@botgarten/content/items'
import { allItems } from './library.ts'

/** The page that prints an item: cards two on a sheet of A4. */
export const onPaper = ({ kind, id }: Pick<Item, 'kind' | 'id'>): string =>
  resolve('/materials/[kind]/[id]?paper=a4', { kind, id })

/** What will Bo do? The questions before and after an item's module; null where it belongs to none. */
export const questionsOf = ({ module }: Pick<Item, 'module'>): string | null =>
  module > 0 ? resolve('/materials/[kind]/[id]', { kind: 'questions', id: String(module) }) : null

/** The teacher's solutions to a set of cards; null for what has none. */
export function solutionsOf({ kind, way }: Pick<Item, 'kind' | 'way'>): Item | null {
  if (kind !== 'card') return null
  const solutions = allItems.filter((item) => item.kind === 'solution')
  // One sheet has those of the first drive and of sorting.
  return solutions.find((one) => one.way === way) ?? solutions.find((one) => one.way === 'all') ?? null
}
