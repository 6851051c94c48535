import { beginExercise, prepare, type Exercise } from '@botgarten/learning/neural-network/examples'
import {
  beginPractice,
  percentOff,
  pointOf,
  stepSome,
  type CurvePoint,
  type Practice,
  type Rows,
  type Settings,
} from '@botgarten/learning/neural-network/train'
import { draw, stream } from '@botgarten/numbers'

/** One practice of several that are compared. */
export interface Line {
  /** Its seed, or how many examples it had. */
  readonly number: number
  readonly curve: readonly CurvePoint[]
}

/** So many seeds lie over each other. */
export const seedsCompared = 8
/** Shares of the examples, for how many are enough. */
const shares = [0.125, 0.25, 0.5, 0.75, 1] as const
/** A curve over rounds has so many points at most. */
const mostPoints = 100

/** The same practice from zero with one seed after the other. Yields after every round. */
export function* overSeeds(exercise: Exercise, settings: Settings): Generator<undefined, readonly Line[]> {
  const lines: Line[] = []
  for (let k = 0; k < seedsCompared; k++) {
    const own: Exercise = { ...exercise, from: 'zero', seed: exercise.seed + k }
    lines.push({ number: own.seed, curve: yield* curveOf(beginExercise(prepare(own), settings, own)) })
  }
  return lines
}

/** The same practice from zero with more and more of the examples; what is kept back stays the same. */
export function* overSizes(exercise: Exercise, settings: Settings): Generator<undefined, readonly Line[]> {
  const { data } = prepare({ ...exercise, from: 'zero' })
  const order = shuffled(data.practised.count, exercise.seed)
  const counts = [...new Set(shares.map((share) => Math.max(1, Math.round(share * order.length))))]
  const lines: Line[] = []
  for (const count of counts) {
    const rows = order.slice(0, count).sort((a, b) => a - b)
    const practised = someOf(data.practised, rows)
    const dice = stream(exercise.seed, `learn/order/${exercise.id}`)
    const curve = yield* curveOf(beginPractice(settings, { ...data, practised }, dice))
    lines.push({ number: count, curve: [...curve.slice(0, 1), curve.at(-1)!] })
  }
  return lines
}

function* curveOf(practice: Practice): Generator<undefined, readonly CurvePoint[]> {
  const every = Math.ceil(practice.settings.rounds / mostPoints)
  const curve = [pointOf(practice)]
  while (practice.ended === null) {
    const { round } = practice
    while (practice.ended === null && practice.round === round) stepSome(practice)
    if (practice.round % every === 0 || practice.ended !== null) curve.push(pointOf(practice))
    yield
  }
  return curve
}

/** Numbers below `count` in an order by chance (Fisher & Yates), the same one for the same seed. */
function shuffled(count: number, seed: number): readonly number[] {
  const dice = stream(seed, 'learn/size')
  const order = Array.from({ length: count }, (_, k) => k)
  for (let k = count - 1; k > 0; k--) {
    const other = Math.floor(draw(dice) * (k + 1))
    ;[order[k], order[other]] = [order[other]!, order[k]!]
  }
  return order
}

function someOf({ count, inputs, targets }: Rows, rows: readonly number[]): Rows {
  const pick = (all: Float64Array) => {
    const width = all.length / count
    return Float64Array.from(rows.flatMap((row) => [...all.subarray(row * width, (row + 1) * width)]))
  }
  return { count: rows.length, inputs: pick(inputs), targets: pick(targets) }
}

/** What a line ends at, as the axis counts it: of what is kept back where there is any. */
export function endOf({ curve }: Line, shares: boolean): number {
  const { practised, kept } = curve.at(-1)!
  const loss = kept ?? practised
  return shares ? loss : percentOff(loss)
}
