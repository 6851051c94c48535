import { createLab, type Check, type Document, type Lab } from '@botgarten/lab'
import { draw, stream } from '@botgarten/numbers'
import { TICKS_PER_SECOND, type Floor, type Pose } from '@botgarten/simulation'

/** Half of a minute, or as long as the card's checks need. */
const shortest = 30
/** How far from a start of the card, in cm and degrees, an unseen one lies at most. */
const around = { cm: 25, degrees: 20 }
/** Without a card: cm that Bo drives at least. */
const farEnough = 100
/** Ticks between two pauses. */
const slice = 30

/** One start that nobody has shown, and what came of it. */
export interface Tried {
  readonly number: number
  readonly passed: boolean
  /** Id of the check that was missed first; '' for a bump, where there is no card, or standing. */
  readonly missed: string
  readonly start: Pose
  /** What the network read where Bo bumped first, else where it ended, in percent; null: it did not run. */
  readonly readings: readonly number[] | null
  /** cm; a few a second. */
  readonly trail: readonly { readonly x: number; readonly y: number }[]
}

/** Starts around those of a card, the same ones for the same seed; without a card all over the floor. */
export function unseenStarts(
  starts: readonly Pose[],
  { width, height }: { readonly width: number; readonly height: number },
  count: number,
  seed: number,
): readonly Pose[] {
  const dice = stream(seed, 'learn/alone')
  const between = (far: number) => (2 * draw(dice) - 1) * far
  return Array.from({ length: count }, (_, k) => {
    const near = starts[k % Math.max(1, starts.length)]
    const [x, y, heading] = [between(1), between(1), between(1)]
    if (!near) return { x: width * (0.5 + 0.38 * x), y: height * (0.5 + 0.38 * y), heading: 180 * heading }
    return {
      x: clamp(near.x + x * around.cm, 15, width - 15),
      y: clamp(near.y + y * around.cm, 15, height - 15),
      heading: near.heading + heading * around.degrees,
    }
  })
}

const clamp = (value: number, least: number, most: number) => Math.max(least, Math.min(most, value))

interface Course {
  readonly document: Document
  readonly floor: Floor
  readonly checks: readonly Check[]
  readonly robot: string
  readonly network: { readonly id: string; readonly inputs: readonly string[] } | null
}

/** Lets Bo drive from each of these starts without a picture. Pauses every half second of Bo's time. */
export function* driveAlone(course: Course, starts: readonly Pose[]): Generator<undefined, readonly Tried[]> {
  const all: Tried[] = []
  for (const [index, start] of starts.entries()) all.push(yield* tried(course, start, index + 1))
  return all
}

function* tried(course: Course, start: Pose, number: number): Generator<undefined, Tried> {
  const { document, floor, checks, robot } = course
  const lab = createLab()
  lab.load(document, floor, { seed: 1, checks })
  const from = lab.place(robot, start)
  lab.start()
  const ticks = Math.max(shortest, ...checks.map(({ seconds }) => seconds)) * TICKS_PER_SECOND
  let bumped = false
  let readings: readonly number[] | null = null
  for (let tick = 0; tick < ticks; tick += slice) {
    lab.advance(slice)
    const bo = lab.view().robots.find(({ id }) => id === robot)
    if (!bumped) readings = readIn(lab, course)
    bumped ||= (bo?.touching.length ?? 0) > 0
    if (checks.length === 0 && bumped) break
    yield
  }
  const view = lab.view()
  const trail = view.robots.find(({ id }) => id === robot)?.trail ?? []
  const open = view.checks.find(({ passed }) => !passed)
  const passed = checks.length > 0 ? !open && !view.problem : !bumped && lengthOf(trail) >= farEnough
  const points = trail.map(({ x, y }) => ({ x, y }))
  return { number, passed, missed: open?.id ?? '', start: from, readings, trail: points }
}

/** What the network reads now. */
function readIn(lab: Lab, { network }: Course): readonly number[] | null {
  const outputs = network && lab.view().networks[network.id]?.outputs
  return outputs ? network.inputs.map((id) => outputs[id] ?? 0) : null
}

function lengthOf(trail: readonly { readonly x: number; readonly y: number }[]): number {
  return trail.reduce((sum, { x, y }, at) => {
    const before = trail[at - 1]
    return before ? sum + Math.hypot(x - before.x, y - before.y) : 0
  }, 0)
}
