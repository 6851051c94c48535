import { cardDocument } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { createLab, type Lab, type View, type Wheels } from '@botgarten/lab'
import type { Brain } from '@botgarten/learning/neural-network'
import type { Drive, Examples } from '@botgarten/learning/neural-network/examples'
import { draw, stream, type StreamState } from '@botgarten/numbers'
import { TICKS_PER_SECOND, type Pose } from '@botgarten/simulation'

// Simulated children who show Friendship: their hand is late and shaky, and each has a seed. They are no children.

const found = content.card('friendship')!
const program = content.program('friendship', 'start')!
const card = found.card
export const network = 'net'
const robot = found.world.robots[0]!.id
/** A hand decides ten times a second, and is late by 0.25 s: three of its decisions. */
const every = 6
const late = 3
/** The blue square: its middle and half of its side, in cm. */
const square = { x: 300, y: 200, half: 25 }

/** How a hand is held: a pad knows all speeds, keys know 60 and ±25. */
export type HandKind = 'pad' | 'keys'

/** What a hand wishes, by what it looks at. */
type Wish = (view: View) => Wheels

const cut = (value: number) => Math.max(-100, Math.min(100, value))

function labAt(brain: Brain | null, pose: Pose): Lab {
  const given = brain ? { ...program, brains: { ...program.brains, [network]: brain } } : program
  const document = cardDocument(found.world, card, given, 0)
  const lab = createLab()
  lab.load(document, content.floorOf(document.world), { seed: 1, checks: [] })
  lab.place(robot, pose)
  return lab
}

const dice = (child: number, what: string): StreamState => stream(child, `bench/show/${what}`)
const between = (state: StreamState, far: number) => (2 * draw(state) - 1) * far
/** About normal, with deviation 1: the sum of twelve uniform draws (Irwin & Hall). */
const shake = (state: StreamState) =>
  Array.from({ length: 12 }, () => draw(state)).reduce((a, b) => a + b) - 6

/** What both eyes read, in percent. */
const eyesIn = (view: View): readonly [number, number] => {
  const { outputs } = view.networks[network]!
  return [outputs['eyeLeft']!, outputs['eyeRight']!]
}

/** Looks from above: steers to the square, slower when near, and stops in front of it. */
export const fromAbove: Wish = (view) => {
  const { x, y, heading } = view.robots[0]!.pose
  const ahead = (heading * Math.PI) / 180
  const bearing = Math.atan2(square.y - y, square.x - x) - ahead
  const aside = Math.atan2(Math.sin(bearing), Math.cos(bearing))
  const [noseX, noseY] = [x + 10 * Math.cos(ahead), y + 10 * Math.sin(ahead)]
  const gap = Math.hypot(
    Math.max(0, Math.abs(noseX - square.x) - square.half),
    Math.max(0, Math.abs(noseY - square.y) - square.half),
  )
  if (gap < 5) return { left: 0, right: 0 }
  const [speed, turn] = [Math.min(70, 10 + gap), Math.max(-35, Math.min(35, 60 * aside))]
  return { left: speed - turn, right: speed + turn }
}

/** Knows only what Bo's eyes read: turns to the nearer side, slower when near. */
export const byEyes: Wish = (view) => {
  const [left, right] = eyesIn(view)
  const near = Math.min(left, right)
  if (near < 6) return { left: 0, right: 0 }
  const speed = near > 60 ? 70 : near > 30 ? 45 : near > 15 ? 25 : 12
  const turn = Math.abs(left - right) > 6 ? (left < right ? 20 : -20) : 0
  return { left: Math.max(0, speed - turn), right: Math.max(0, speed + turn) }
}

const asKeys = ({ left, right }: Wheels): Wheels => {
  const [ahead, aside] = [(left + right) / 2, (left - right) / 2]
  const speed = ahead > 20 ? 60 : ahead < -20 ? -60 : 0
  const turn = Math.abs(aside) > 10 ? 25 * Math.sign(aside) : 0
  return { left: cut(speed + turn), right: cut(speed - turn) }
}

/** A hand that is late and trembles. */
function handOf(wish: Wish, kind: HandKind, state: StreamState) {
  const waiting: Wheels[] = []
  let [tremble, held]: [number, Wheels] = [0, { left: 0, right: 0 }]
  return (view: View): Wheels => {
    const { left, right } = wish(view)
    tremble = 0.8 * tremble + 3 * shake(state)
    const wanted = { left: cut(left + tremble), right: cut(right - tremble) }
    waiting.push(kind === 'keys' ? asKeys(wanted) : wanted)
    if (waiting.length > late) held = waiting.shift()!
    return held
  }
}

/** Lets the lab run and asks a hand ten times a second; null: it lets go. */
function drives(lab: Lab, seconds: number, hand: (view: View, tick: number) => Wheels | null): void {
  lab.start()
  for (let tick = 0; tick < seconds * TICKS_PER_SECOND; tick += every) {
    const view = lab.view()
    lab.drive(view.networks[network] ? hand(view, tick) : null)
    lab.advance(every)
  }
  lab.record(null)
}

const examplesIn = (lab: Lab): Examples | undefined => lab.document().brains[network]?.examples
const withExamples = (brain: Brain | null, examples: Examples | undefined): Brain => ({
  ...(brain ?? program.brains[network]!),
  ...(examples && { examples }),
})

/** Starts near those of the card. */
function startsOf(state: StreamState): readonly Pose[] {
  return card.starts.map(({ x, y, heading }) => ({
    x: x + between(state, 10),
    y: y + between(state, 10),
    heading: heading + between(state, 10),
  }))
}

const driveOf = (by: Drive['by'], number: number): Drive => ({ id: `${by}-${number}`, by, seed: 1 })

/** Drives from every start for 12 seconds. */
export function drivesFriendship(child: number, wish: Wish, kind: HandKind): Examples {
  const state = dice(child, `${kind} drives`)
  let examples: Examples | undefined
  for (const [k, pose] of startsOf(state).entries()) {
    const lab = labAt(withExamples(null, examples), pose)
    lab.record({ robot, network, drive: driveOf(kind, k + 1), every })
    drives(lab, 12, handOf(wish, kind, state))
    examples = examplesIn(lab)
  }
  return examples!
}

/** Puts Bo to so many places around the square and sets the wheels for each, rounded to 5. */
export function remembersFriendship(child: number, count: number): Examples {
  const state = dice(child, 'remembers')
  let examples: Examples | undefined
  for (let tries = 0; (examples?.rows.length ?? 0) < count && tries < 500; tries++) {
    const [angle, far] = [Math.PI * between(state, 1), 85 + between(state, 55)]
    const [x, y] = [square.x + far * Math.cos(angle), square.y + far * Math.sin(angle)]
    const heading = (Math.atan2(square.y - y, square.x - x) * 180) / Math.PI + between(state, 30)
    const lab = labAt(withExamples(null, examples), { x, y, heading })
    const { left, right } = byEyes(lab.view())
    const set = (value: number) => 5 * Math.round(cut(value === 0 ? 0 : value + 5 * shake(state)) / 5) + 0
    const wheels = { left: set(left), right: set(right) }
    lab.remember({ robot, network, drive: driveOf('hand', tries + 1), wheels, others: {} })
    examples = examplesIn(lab)
  }
  return examples!
}

/** The network drives from every start; where it is far from what the child wishes, the child takes over for half a second. */
export function coachesFriendship(child: number, brain: Brain, round: number): Examples {
  const state = dice(child, `coach ${round}`)
  let { examples } = brain
  for (const [k, pose] of startsOf(state).entries()) {
    const lab = labAt(withExamples(brain, examples), pose)
    lab.record({ robot, network, drive: driveOf('coach', 3 * round + k + 1), every })
    let until = 0
    drives(lab, 12, (view, tick) => {
      const wanted = fromAbove(view)
      const { outputs } = view.networks[network]!
      const off =
        Math.abs(wanted.left - outputs['wheelLeft']!) + Math.abs(wanted.right - outputs['wheelRight']!)
      if (off > 30) until = tick + 30
      return tick < until ? wanted : null
    })
    examples = examplesIn(lab)
  }
  return examples!
}

/** From which of the card's starts Bo passes all checks with this brain. */
export const passes = (brain: Brain): readonly boolean[] =>
  card.starts.map((_, start) => {
    const given = { ...program, brains: { ...program.brains, [network]: brain } }
    const document = cardDocument(found.world, card, given, start)
    const lab = createLab()
    lab.load(document, content.floorOf(document.world), { seed: 1, checks: card.checks })
    lab.start()
    lab.advance(Math.max(40, ...card.checks.map(({ seconds }) => seconds)) * TICKS_PER_SECOND)
    const view = lab.view()
    return view.problem === null && view.checks.every(({ passed }) => passed)
  })

export const emptyBrain = (): Brain => program.brains[network]!
