import { setOf } from '#figures/things/sets.ts'
import { apart, type Field, type Spot } from './geometry.ts'
import type { Work } from './work.ts'

/** Between trays, px. */
const GAP = 14
/** From the upper edge of a tray to the feet of flags, and to the next flag on the same tray. */
const FLAG = { top: 78, aside: 44 }

export interface Tray extends Spot {
  readonly left: number
  readonly top: number
  readonly width: number
  readonly height: number
}

/** One feature of words alone counts: then there is nothing between its words, and no axis. */
export function isOnTrays({ source, set, counting }: Work): boolean {
  if (source !== 'things' || counting.length !== 1) return false
  return setOf(set).features.find(({ id }) => id === counting[0])?.kind === 'choice'
}

/** Trays side by side, one a word, with their middles. */
export function traysIn({ left, top, width, height }: Field, count: number): readonly Tray[] {
  const each = (width - (count - 1) * GAP) / count
  return Array.from({ length: count }, (_, at) => {
    const from = left + at * (each + GAP)
    return { left: from, top, width: each, height, x: from + each / 2, y: top + height / 2 }
  })
}

const trayOf = (row: readonly number[]) => row.indexOf(Math.max(...row))

/** Every thing on the tray of its word, none on another. */
export function spotsOn(trays: readonly Tray[], rows: readonly (readonly number[])[], least: number): Spot[] {
  const spots: Spot[] = []
  trays.forEach((tray, at) => {
    const own = rows.flatMap((row, index) => (trayOf(row) === at ? [index] : []))
    const inside = {
      left: tray.left + 24,
      top: tray.top + 24,
      width: tray.width - 48,
      height: tray.height - 48,
    }
    apart(
      own.map(() => ({ x: tray.x, y: tray.y })),
      least,
      inside,
    ).forEach((spot, index) => (spots[own[index]!] = spot))
  })
  return spots
}

/** Where flags stand: over the trays whose things they have, between them where it is things of several. */
export function flagsOn(trays: readonly Tray[], centres: readonly (readonly number[])[]): Spot[] {
  return centres.map((centre, flag) => {
    const all = centre.reduce((sum, value) => sum + value, 0)
    const x = trays.reduce(
      (sum, tray, at) => sum + tray.x * (all > 0 ? centre[at]! / all : 1 / trays.length),
      0,
    )
    return { x: x + (flag - (centres.length - 1) / 2) * FLAG.aside, y: trays[0]!.top + FLAG.top }
  })
}

/** The middle of a flag that is set on a tray: that word and no other. */
export function centreOn(trays: readonly Tray[], x: number, scale: number): number[] {
  const near = trays.reduce(
    (best, tray, at) => (Math.abs(tray.x - x) < Math.abs(trays[best]!.x - x) ? at : best),
    0,
  )
  return trays.map((_, at) => (at === near ? scale : 0))
}
