import { draw, type StreamState } from '@botgarten/numbers'
import type { Learner } from '../learner.ts'
import { refuseOutside, type ObjectSchema, type ParameterSchema } from '../parameters.ts'
import { chooseAction, emptyTable, learn, rhoAt } from './table.ts'
import type { QTable, Settings, TryTrace } from './types.ts'

/** A world without a robot, for what can be worked out: each action of a state leads to one state and pays. */
export interface SmallWorld {
  /** By state, then action. */
  readonly to: readonly (readonly number[])[]
  readonly reward: readonly (readonly number[])[]
  /** Where a try ends; no action is taken there. */
  readonly ends: readonly boolean[]
  /** Where a try begins, one of them by chance. */
  readonly starts: readonly number[]
}

interface State {
  readonly world: SmallWorld
  readonly settings: Settings
  readonly stream: StreamState
  readonly table: QTable
  /** −1: a new try begins. */
  at: number
}

interface Saved {
  readonly q: readonly number[]
  readonly tries: readonly number[]
  readonly moves: number
  readonly at: number
  readonly stream: StreamState
}

const share: ParameterSchema = { type: 'number', minimum: 0, maximum: 1 }

const parameters: ObjectSchema = {
  type: 'object',
  properties: {
    ...{ alpha: share, gamma: share, rho: share },
    fall: { type: 'integer', minimum: 1, maximum: 1_000_000 },
    alphaDecay: { enum: ['constant', 'visits'] },
  },
  required: ['alpha', 'gamma', 'rho', 'fall'],
  additionalProperties: false,
}

function begin(settings: Settings, world: SmallWorld, stream: StreamState): State {
  refuseOutside(parameters, settings)
  const actions = world.to[0]?.length ?? 0
  if (actions === 0 || world.starts.length === 0)
    throw new RangeError('The world has no actions or no starts.')
  return { world, settings, stream, table: emptyTable(world.to.length, actions), at: -1 }
}

function step(state: State, trace?: (trace: TryTrace) => void): void {
  const { world, settings, stream, table } = state
  const actions = world.to[0]!.length
  if (state.at < 0) state.at = world.starts[Math.floor(draw(stream) * world.starts.length)]!
  const from = state.at
  const { action, explores } = chooseAction(table.q, from, actions, rhoAt(settings, table.moves), stream)
  const to = world.to[from]![action]!
  const ends = world.ends[to]!
  const reward = world.reward[from]![action]!
  const update = learn(table, actions, settings, { from, action, reward, to, ends })
  state.at = ends ? -1 : to
  trace?.({
    ...{ t: table.moves, from, action, decision: explores ? 'explore' : 'exploit' },
    ...{ to, reward, ...update, ends },
  })
}

const save = ({ table: { q, tries, moves }, at, stream }: State): Saved => ({
  ...{ q: [...q], tries: [...tries], moves, at },
  stream: [...stream],
})

function restore(state: State, saved: Saved): void {
  const { table } = state
  if (saved.q.length !== table.q.length || saved.tries.length !== table.tries.length)
    throw new RangeError('The saved table is of another world.')
  table.q.splice(0, Infinity, ...saved.q)
  table.tries.splice(0, Infinity, ...saved.tries)
  table.moves = saved.moves
  state.at = saved.at
  state.stream.splice(0, 4, ...saved.stream)
}

/** Learning by trying over buckets of what is sensed. */
export const qSenses: Learner<Settings, SmallWorld, State, Saved, TryTrace> = {
  ...{ name: 'try', parameters, begin, step, save, restore },
}
