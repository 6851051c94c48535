import { heatOf, mix } from '#drawing/colours.ts'
import type { Cell } from '../model/table.ts'

/** Nothing is known of it. */
const pale = '#F4EBDA'
/** From a little below nothing to the least of all. */
const loss = ['#FBE6DF', '#EFA996'] as const

/** Colour of a cell: pale where nobody has tried, rose below 0, gold and green above. Ink on it has at least 5 : 1. */
export function heat({ value, tries }: Cell, { most, least }: { most: number; least: number }): string {
  if (tries === 0) return pale
  if (value < 0) return mix(loss[0], loss[1], Math.min(1, value / least))
  return heatOf((100 * value) / most)
}
