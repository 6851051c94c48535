import type { PayKind, Sentence, Trial } from './types.ts'

export const limits = {
  sensors: 3,
  states: 200,
  sentences: 6,
  coins: 20,
  actions: 12,
  starts: 8,
  minutes: 60,
  hold: [6, 60],
} as const

/** cm for which a child pays a coin. */
const wayUnit = 4

/** How much of a kind one coin of a child's sentence pays for: of ways 4 cm, of all else one unit. */
export const unitOf = (kind: PayKind): number => (kind === 'ahead' || kind === 'way' ? wayUnit : 1)

/** Which bucket a reading falls into: how many of the edges it has reached. */
export function bucketOf(reading: number, edges: readonly number[]): number {
  let bucket = 0
  while (bucket < edges.length && reading >= edges[bucket]!) bucket++
  return bucket
}

/** How many states these buckets make, the bump among them. */
export const statesOf = ({ edges, bump }: Pick<Trial, 'edges' | 'bump'>): number =>
  edges.reduce((product, own) => product * (own.length + 1), 1) + (bump ? 1 : 0)

/** The state of these readings: buckets as digits, the first sensor's counting most; while it touches, the last state. */
export function stateOf(
  { edges, bump }: Pick<Trial, 'edges' | 'bump'>,
  readings: readonly number[],
  touches: boolean,
): number {
  if (bump && touches) return statesOf({ edges, bump }) - 1
  return edges.reduce((state, own, k) => state * (own.length + 1) + bucketOf(readings[k]!, own), 0)
}

/** The buckets of a state, sensor by sensor; null: the bump. */
export function bucketsOf(trial: Pick<Trial, 'edges' | 'bump'>, state: number): readonly number[] | null {
  if (trial.bump && state === statesOf(trial) - 1) return null
  let rest = state
  return [...trial.edges]
    .reverse()
    .map(({ length }) => {
      const bucket = rest % (length + 1)
      rest = (rest - bucket) / (length + 1)
      return bucket
    })
    .reverse()
}

/** What happened in one move, each in the unit that is paid for. */
export type Facts = { readonly [kind in PayKind]: number }

/** All coins of a move, sentence by sentence in their order. */
export const payFor = (pay: readonly Sentence[], facts: Facts): number =>
  pay.reduce((sum, { for: what, coins }) => sum + coins * facts[what], 0)

/** Why nothing can be learned: its name in the words. */
export type Problem =
  | 'tryNoSenses'
  | 'tryManySenses'
  | 'tryManyStates'
  | 'tryNoActions'
  | 'tryManyActions'
  | 'tryManySentences'
  | 'tryNoPay'

export function problemOf(trial: Trial): Problem | null {
  const { sensors, actions, pay } = trial
  if (sensors.length === 0) return 'tryNoSenses'
  if (sensors.length > limits.sensors) return 'tryManySenses'
  if (statesOf(trial) > limits.states) return 'tryManyStates'
  if (actions.length < 2) return 'tryNoActions'
  if (actions.length > limits.actions) return 'tryManyActions'
  if (pay.length > limits.sentences) return 'tryManySentences'
  return pay.every(({ coins }) => coins === 0) ? 'tryNoPay' : null
}

/** Was this table learned by such a trial? */
export const isOf = (trial: Trial, table: Trial): boolean => signOf(trial) === signOf(table)

const signOf = ({ sensors, edges, bump, actions, hold, pay, bumpEnds, ...rest }: Trial): string => {
  const { alpha, gamma, rho, seed, starts = [] } = rest
  const plain = [
    sensors.map(({ port, mode }) => [port, mode]),
    actions.map(({ left, right, lamp }) => [left, right, lamp]),
    pay.map(({ for: what, coins }) => [what, coins]),
    starts.map(({ x, y }) => [x, y]),
  ]
  return JSON.stringify([...plain, edges, bump, hold, bumpEnds, alpha, gamma, rho, seed])
}
