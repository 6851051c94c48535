import { billOf, type Ground, type LaneKind, type Racer } from '@botgarten/experiments/brain-race'
import { headOfRow, place, type Examples } from '@botgarten/learning/neural-network/examples'
import type { Effort } from '@botgarten/programs'
import { practisedAgain, triedAgain } from './again.ts'

/** Whose eyes read less, in cm, stands at a wall. */
const atWall = 1

/**
 * What a course's ready-made brain has cost, as far as that is known from making it again; no child has built it, so there is
 * no time of a hand.
 * @param clock seconds of the processor; they are no part of what is the same everywhere
 */
export function effortOf(ground: Ground, kind: LaneKind, racer: Racer, clock: () => number): Partial<Effort> {
  const began = clock()
  if (kind === 'hand') return { knobs: billOf(kind, racer).parts }
  if (kind === 'trying') {
    const bumps = bumpsTried(ground, racer)
    return { bumps, computer: clock() - began }
  }
  if (kind !== 'examples') return {}
  const { brain } = practisedAgain(racer, ground.world.robots[0]!.config)
  return { bumps: bumpsShown(brain.examples!), computer: clock() - began }
}

/** Its tries begin on the first start alone. */
function bumpsTried({ course, world, floor }: Ground, racer: Racer): number {
  const robots = [{ ...world.robots[0]!, pose: course.starts[0]! }]
  const { curve, minute } = triedAgain(racer, { ...world, robots }, floor).state
  return curve.reduce((sum, { bumps }) => sum + bumps, minute.bumps)
}

/** How often an eye came to a wall in a drive that was shown. Where a hand put the robot nothing was driven. */
function bumpsShown({ drives, rows, inputs }: Examples): number {
  const touches = rows.map((row) => {
    const eyes = row.slice(headOfRow, headOfRow + inputs.length)
    return drives[row[place.drive]!]!.by !== 'hand' && eyes.some((read) => read !== null && read < atWall)
  })
  return touches.filter((touch, at) => touch && !touches[at - 1]).length
}
