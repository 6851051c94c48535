import { emptyBrain } from '@botgarten/learning/neural-network/brain'
import type { Program } from '../../types.ts'
import { project } from '../../testing/every-part.ts'
import { indexOf, spotsIn } from '../tree.ts'
import type { Operation, Place, Shared } from '../types.ts'

/** What two begin with: a program, one network, one thing. */
export const sharedWith = (main: Program): Shared => ({
  programs: { ...project.programs, main },
  brains: { net: { ...emptyBrain, weights: { left: { right: 0.5 } } } },
  world: project.world,
})

export const idsOf = ({ programs }: Shared): ReadonlySet<string> =>
  new Set(indexOf(programs['main']!.stacks).keys())

/** A number that decides. */
type Dice = (sides: number) => number

function somewhere(shared: Shared, dice: Dice): Place {
  const spots = spotsIn(shared.programs['main']!.stacks)
  if (spots.length === 0) return { x: dice(500), y: dice(500) }
  const { id } = spots[dice(spots.length)]!.block
  const places: readonly Place[] = [
    { x: dice(500), y: dice(500) },
    { after: id },
    { before: id },
    { in: id, statement: ['DO', 'DO0', 'ELSE'][dice(3)]! },
    { in: id, value: ['A', 'B', 'POWER'][dice(3)]! },
  ]
  return places[dice(places.length)]!
}

/** Any operation that a hand could do there; `fresh`: a name for a new block. */
export function anyOperation(shared: Shared, dice: Dice, fresh: string): Operation {
  const program = 'main'
  const ids = [...idsOf(shared)]
  const block = ids[dice(Math.max(1, ids.length))] ?? fresh
  const square = { ...project.world.obstacles[0]!, id: `thing-${dice(3)}` }
  const all: readonly (() => Operation)[] = [
    () => ({
      kind: 'add',
      program,
      block: { id: fresh, type: 'robControls_loopForever' },
      place: somewhere(shared, dice),
    }),
    () => ({ kind: 'move', program, block, place: somewhere(shared, dice) }),
    () => ({ kind: 'delete', program, block }),
    () => ({ kind: 'field', program, block, name: 'NUM', value: String(dice(9)) }),
    () => ({ kind: 'part', program, block, name: 'disabled', value: dice(2) === 0 || null }),
    () => ({ kind: 'knob', path: ['net', 'weights', 'left', ['right', 'up'][dice(2)]!], value: dice(9) / 8 }),
    () => ({ kind: 'thing', path: ['obstacles', square.id], value: dice(2) === 0 ? square : null }),
    () => ({
      kind: 'thing',
      path: ['obstacles', square.id, 'pose'],
      value: { x: dice(90), y: dice(90), heading: 0 },
    }),
  ]
  // Blocks are put, moved and deleted most.
  return all[[0, 0, 1, 1, 1, 2, 2, 3, 4, 5, 6, 7][dice(12)]!]!()
}
