import type { Document } from '@botgarten/lab'
import { cluster, pointsOf } from '@botgarten/learning/k-means'
import { courseOf, type MapFile } from '@botgarten/maps'
import { learnIn, type Cage } from '@botgarten/maps/zoo'
import { learningIn } from '@botgarten/programs'
import type { Floor, Pose, Seconds } from '@botgarten/simulation'
import { rideOf } from './ride.ts'

/** What is looked at. `group`: flags stand at things; with which of them does another thing end? */
export type Asked =
  | { readonly observe: 'moves' | 'meets' | 'lamp' | 'tone'; readonly seconds: Seconds }
  | { readonly observe: 'way' }
  | { readonly observe: 'cage'; readonly setting: number }
  | { readonly observe: 'group'; readonly flags: readonly string[]; readonly thing: string }

/** What is needed to find out. `things`: where each lies, by its name. */
export type Given =
  | { readonly kind: 'lab'; readonly document: Document; readonly floor: Floor }
  | { readonly kind: 'learning'; readonly document: Document; readonly map: MapFile }
  | { readonly kind: 'cage'; readonly cage: Cage; readonly map: MapFile }
  | { readonly kind: 'things'; readonly things: ReadonlyMap<string, readonly number[]> }

type AskedOfRobot = Extract<Asked, { seconds: Seconds }>
type AskedOfGroups = Extract<Asked, { observe: 'group' }>

/** Turned less than this, in degrees, a robot has driven straight on. */
const STRAIGHT = 10
/** Gone less than this along each side of the world, in cm, a robot stands. */
const STANDS = 1
/** Tones closer than this, in hertz, are the same. */
const SAME = 10

/**
 * What really happens, with the lab's own robot, learner and sorting.
 * - `moves`: `stands`, `straight`, `left`, `right` · `meets`: `touches` (at any time), `stops`, `drives` (at the end)
 * - `lamp` at the end: `off`, `green`, `orange`, `red` · `tone` from first to last: `silent`, `higher`, `lower`, `same`
 * - `way`: its stations, `3-5-0-1`, or `none` · `group`: the thing at whose flag it ends
 * - `cage`: what is learned there: `wish`, `other`, `never`
 * @throws TypeError where what is given does not fit what is asked; RangeError for a thing that is not there
 */
export function outcomeOf(asked: Asked, given: Given): string {
  if (asked.observe === 'group' && given.kind === 'things') return groupOf(asked, given.things)
  if (asked.observe === 'way' && given.kind === 'learning') return wayOf(given.document, given.map)
  if (asked.observe === 'cage' && given.kind === 'cage')
    return learnIn(given.cage, given.map, asked.setting, 1).outcome
  if ('seconds' in asked && given.kind === 'lab') return robotOutcome(asked, given.document, given.floor)
  throw new TypeError(`"${asked.observe}" cannot be seen in "${given.kind}".`)
}

function robotOutcome({ observe, seconds }: AskedOfRobot, document: Document, floor: Floor): string {
  const { poses, touched, end } = rideOf(document, floor, seconds)
  switch (observe) {
    case 'moves':
      return movesOf(poses)
    case 'meets':
      if (touched) return 'touches'
      return Object.values(end.motors).every((percent) => Math.abs(percent) < 4) ? 'stops' : 'drives'
    case 'lamp':
      return end.led ?? 'off'
    case 'tone':
      return toneOf(end.tones.map(({ frequency }) => frequency).filter((frequency) => frequency > 0))
  }
}

function movesOf(poses: readonly Pose[]): string {
  const turned = poses.slice(1).reduce((sum, { heading }, at) => sum + turn(poses[at]!.heading, heading), 0)
  if (turned >= STRAIGHT) return 'left'
  if (turned <= -STRAIGHT) return 'right'
  const first = poses[0]!
  const last = poses.at(-1)!
  return Math.max(Math.abs(last.x - first.x), Math.abs(last.y - first.y)) < STANDS ? 'stands' : 'straight'
}

/** From one heading to the next, the short way round, in degrees; to the left is positive. */
const turn = (from: number, to: number): number => ((((to - from + 180) % 360) + 360) % 360) - 180

function toneOf(tones: readonly number[]): string {
  const first = tones[0]
  if (first === undefined) return 'silent'
  const change = tones.at(-1)! - first
  if (Math.abs(change) < SAME) return 'same'
  return change > 0 ? 'higher' : 'lower'
}

function wayOf(document: Document, map: MapFile): string {
  const program = document.programs[document.world.robots[0]!.program]!
  const outline = learningIn(program)
  if (!outline) throw new TypeError('This program learns no way.')
  const course = courseOf(outline, map, 1)
  course.advance(outline.moves)
  return course.way().states?.join('-') ?? 'none'
}

function groupOf({ flags, thing }: AskedOfGroups, things: ReadonlyMap<string, readonly number[]>): string {
  const names = [...things.keys()]
  const rowOf = (name: string) => {
    const row = things.get(name)
    if (!row) throw new RangeError(`There is no "${name}" among the things.`)
    return row
  }
  rowOf(thing)
  const { labels } = cluster(pointsOf([...things.values()]), flags.map(rowOf))
  return flags[labels[names.indexOf(thing)]!]!
}
