import { draw, stream } from '@botgarten/numbers'
import type { ShownPair } from './rows.ts'
import type { Drive } from './types.ts'

/** With fewer examples or drives nothing is held back. */
const fewest = { rows: 10, drives: 2 }

export interface Split {
  readonly practised: readonly ShownPair[]
  readonly kept: readonly ShownPair[]
  /** Does the draw hold back none or all, so that somebody should choose a drive for the test? */
  readonly asks: boolean
}

/**
 * Holds whole drives back for a test: rows of one drive are nearly twins. A drive is held back when its own draw is below the
 * share, so that a new drive moves no other one; what was chosen by hand goes before the draw.
 */
export function splitDrives(
  pairs: readonly ShownPair[],
  drives: readonly Drive[],
  seed: number,
  share: number,
): Split {
  const used = [...new Set(pairs.map(({ drive }) => drive))]
  const nothing = { practised: pairs, kept: [] }
  if (share === 0 || pairs.length < fewest.rows || used.length < fewest.drives)
    return { ...nothing, asks: false }
  const held = new Set(used.filter((index) => isHeld(drives[index]!, seed, share)))
  if (held.size === 0 || held.size === used.length) return { ...nothing, asks: true }
  return {
    practised: pairs.filter(({ drive }) => !held.has(drive)),
    kept: pairs.filter(({ drive }) => held.has(drive)),
    asks: false,
  }
}

const isHeld = ({ id, test }: Drive, seed: number, share: number) =>
  test ?? draw(stream(seed, `learn/split/${id}`)) < share
