import { createLab, type Document, type Lab } from '@botgarten/lab'
import { cluster, pointsOf } from '@botgarten/learning/k-means'
import { learningIn } from '@botgarten/programs'
import { TICKS_PER_SECOND, type Floor, type Pose } from '@botgarten/simulation'
import { courseOf } from '@botgarten/maps'
import type { MapFile } from '@botgarten/maps'
import { columnsOf, onPlane, rawOf } from '../things/columns.ts'
import type { Thing, ThingSet } from '../schema/thingTypes.ts'
import type { Given, QuestionRun } from '../schema/questionTypes.ts'

type LabRun = Extract<QuestionRun, { card: string; seconds: number }>
type GroupRun = Extract<QuestionRun, { observe: 'group' }>

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
 * @throws TypeError where what is given does not fit what is asked; RangeError for a thing that is not there
 */
export function outcomeOf(run: QuestionRun, given: Given): string {
  if (run.observe === 'group' && given.kind === 'things') return groupOf(run, given.set)
  if (run.observe === 'way' && given.kind === 'learning') return wayOf(given.document, given.map)
  if ('seconds' in run && given.kind === 'lab') return robotOutcome(run, given.document, given.floor)
  throw new TypeError(`"${run.observe}" cannot be seen in "${given.kind}".`)
}

function robotOutcome(run: LabRun, document: Document, floor: Floor): string {
  const lab = createLab()
  lab.load(document, floor, { seed: 1, checks: [] })
  lab.start()
  const { poses, touched } = watch(lab, run.seconds * TICKS_PER_SECOND)
  const robot = lab.view().robots[0]!
  switch (run.observe) {
    case 'moves':
      return movesOf(poses)
    case 'meets':
      if (touched) return 'touches'
      return Object.values(robot.motors).every((percent) => Math.abs(percent) < 4) ? 'stops' : 'drives'
    case 'lamp':
      return robot.led ?? 'off'
    case 'tone':
      return toneOf(robot.tones.map(({ frequency }) => frequency).filter((frequency) => frequency > 0))
  }
}

/** Where the robot was at every tick, and whether it has touched anything on the way. */
function watch(lab: Lab, ticks: number): { readonly poses: readonly Pose[]; readonly touched: boolean } {
  const poses = [lab.view().robots[0]!.pose]
  let touched = false
  for (let tick = 0; tick < ticks; tick++) {
    lab.advance(1)
    const { pose, touching } = lab.view().robots[0]!
    poses.push(pose)
    touched ||= touching.length > 0
  }
  return { poses, touched }
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
  return course.way().stations?.join('-') ?? 'none'
}

function groupOf({ features, flags, thing }: GroupRun, set: ThingSet): string {
  const columns = columnsOf(set, features)
  const place = (one: Thing) => columns.map((column) => onPlane(rawOf(set, one, column), column))
  const at = (id: string) => {
    const index = set.things.findIndex((one) => one.id === id)
    if (index < 0) throw new RangeError(`There is no "${id}" in "${set.id}".`)
    return index
  }
  const rows = set.things.map(place)
  const { labels } = cluster(
    pointsOf(rows),
    flags.map((id) => rows[at(id)]!),
  )
  return flags[labels[at(thing)]!]!
}
