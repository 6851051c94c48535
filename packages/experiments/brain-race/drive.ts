import { createLab, type Document, type RobotView } from '@botgarten/lab'
import { TICKS_PER_SECOND, type Pose } from '@botgarten/simulation'
import { checksFor, scoreOf, worstOf } from './measure.ts'
import type { Ground, Place, Racer, Run } from './types.ts'

/** Ticks between two places of a trail, and between two pauses. */
const every = 6
/** Gone less than this, in cm, a robot has not moved. */
const STANDS = 1

/**
 * A brain drives from one start: frozen, alone, with the same noise as every other one. Pauses ten times a second of its time,
 * and gives its run when it is over.
 */
export function* drive(ground: Ground, racer: Racer, start: Pose, seed: number): Generator<undefined, Run> {
  const { course, floor } = ground
  const { seconds, measure } = course
  const lab = createLab()
  lab.load(documentOf(ground, racer), floor, { seed, checks: checksFor(measure, seconds) })
  const from = lab.place(ground.world.robots[0]!.id, start)
  lab.start()
  const tally = begin(from)
  for (let tick = 1; tick <= seconds * TICKS_PER_SECOND; tick++) {
    lab.advance(1)
    note(tally, lab.view().robots[0]!, tick)
    if (tick % every === 0) yield
  }
  const cm = (tally.cm * 60) / seconds
  return {
    ...{ from, moved: !isSame(from, start), cm, bumps: tally.bumps, trail: tally.trail },
    atWall: tally.touches / (seconds * TICKS_PER_SECOND),
    decisions: lab.state().threads[0]?.decisions ?? 0,
    score: tally.cm < STANDS ? worstOf(measure, seconds) : scoreOf(measure, lab, cm, seconds),
  }
}

/** One robot with the course's body and the racer's program. */
function documentOf({ world }: Ground, { programs, brains, tables }: Racer): Document {
  const robot = world.robots[0]!
  const program = Object.keys(programs)[0] ?? robot.program
  return {
    programs,
    brains,
    ...(tables && { tables }),
    world: { ...world, robots: [{ ...robot, program, brain: '' }] },
  }
}

interface Tally {
  readonly trail: Place[]
  at: Place
  cm: number
  bumps: number
  touches: number
  touching: boolean
}

function begin({ x, y }: Pose): Tally {
  const at = { x, y }
  return { trail: [at], at, cm: 0, bumps: 0, touches: 0, touching: false }
}

function note(tally: Tally, { pose: { x, y }, touching: things }: RobotView, tick: number): void {
  const touching = things.length > 0
  const [dx, dy] = [x - tally.at.x, y - tally.at.y]
  tally.cm += Math.sqrt(dx * dx + dy * dy)
  if (touching && !tally.touching) tally.bumps++
  if (touching) tally.touches++
  tally.touching = touching
  tally.at = { x, y }
  if (tick % every === 0) tally.trail.push(tally.at)
}

const isSame = (a: Pose, b: Pose) =>
  Math.abs(a.x - b.x) < 0.01 && Math.abs(a.y - b.y) < 0.01 && Math.abs(a.heading - b.heading) < 0.01
