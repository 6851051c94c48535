import {
  chooseAction,
  emptyTable,
  learn,
  payFor,
  rhoAt,
  statesOf,
  stateOf,
  type Minute,
  type Place,
  type QTable,
  type Settings,
  type TableBrain,
  type Trial,
  type TryTrace,
} from '@botgarten/learning/q-senses'
import { draw, stream, type StreamState } from '@botgarten/numbers'
import { TICKS_PER_SECOND, type Simulation } from '@botgarten/simulation'
import { drive, factsOf, readingsOf, sightOf, tileAt, touchesIn, type Sight } from './body.ts'

/** Ticks after which a try is over. */
const longestTry = 60 * TICKS_PER_SECOND
/** Over so many ticks ρ falls. */
const fallTicks = 8 * 60 * TICKS_PER_SECOND
/** Who has never been so far from its start, cm, and touches something at the end, could not get away. */
const free = 20
const minuteTicks = 60 * TICKS_PER_SECOND

/** A robot that learns by trying, as plain data: it goes on from a copy bit for bit. */
export interface TryState {
  readonly trial: Trial
  readonly table: QTable
  /** Of the present try. */
  stream: StreamState
  /** Tries begun so far. */
  attempts: number
  /** Ticks of the present try, and of all. */
  ticks: number
  total: number
  /** −1: a new try begins. */
  state: number
  action: number
  explores: boolean
  /** For how many ticks it has been doing so. */
  held: number
  before: Sight | null
  bumped: boolean
  /** Squares of the floor where this try has been. */
  tiles: number[]
  /** Where it began, and how far from there it has been, cm. */
  begun: Place
  away: number
  /** Whole minutes, and the one under way. */
  curve: Minute[]
  minute: Minute
  /** Tries in which it could not get away from where it began. */
  stuck: number
  /** Which of its starts this try has begun at, and at which it was stuck last; −1: none. */
  start: number
  stuckAt: number
  last: TryTrace | null
}

export function beginTry(trial: Trial): TryState {
  return {
    trial,
    table: emptyTable(statesOf(trial), trial.actions.length),
    stream: stream(trial.seed, 'learn/try'),
    ...{ attempts: 0, ticks: 0, total: 0, state: -1, action: 0, explores: false, held: 0 },
    ...{ before: null, bumped: false, tiles: [], begun: { x: 0, y: 0 }, away: 0 },
    ...{ curve: [], minute: { pay: 0, bumps: 0 }, stuck: 0, start: 0, stuckAt: -1, last: null },
  }
}

const settingsOf = ({ alpha, gamma, rho, hold }: Trial): Settings => ({
  ...{ alpha, gamma, rho },
  fall: Math.ceil(fallTicks / hold),
})

/**
 * One tick's part of the program (running.md 2): at its beginning a move that has been held for long enough is learned
 * from, and the next one begins.
 */
export function tryTick(state: TryState, simulation: Simulation, robot: number): void {
  if (state.state < 0) beginAttempt(state, simulation, robot)
  else {
    state.held++
    state.ticks++
    state.total++
    state.bumped ||= touchesIn(simulation, robot)
    if (state.held >= state.trial.hold) conclude(state, simulation, robot)
    if (state.total % minuteTicks === 0) turnMinute(state)
    if (state.state < 0) beginAttempt(state, simulation, robot)
    else if (state.held > 0) return
  }
  decide(state, simulation, robot)
}

/** Puts the robot to its start, or to one of several, facing anywhere. */
function beginAttempt(state: TryState, simulation: Simulation, robot: number): void {
  const { id, pose } = simulation.world.robots[robot]!
  const { seed, starts = [pose] } = state.trial
  state.stream = stream(seed, `learn/try/${id}/${state.attempts++}`)
  const at = starts.length > 1 ? Math.floor(draw(state.stream) * starts.length) : 0
  const { x, y } = starts[at] ?? pose
  simulation.place(id, { x, y, heading: Math.floor(draw(state.stream) * 360) })
  state.start = at
  state.ticks = 0
  state.before = sightOf(simulation, robot)
  state.tiles = [tileAt(state.before)]
  state.begun = { x: state.before.x, y: state.before.y }
  state.away = 0
  state.state = stateNow(state, simulation, robot)
}

function stateNow({ trial }: TryState, simulation: Simulation, robot: number): number {
  return stateOf(trial, readingsOf(simulation, robot, trial), touchesIn(simulation, robot))
}

function decide(state: TryState, simulation: Simulation, robot: number): void {
  const { trial, table } = state
  const epsilon = rhoAt(settingsOf(trial), table.moves)
  const { action, explores } = chooseAction(table.q, state.state, trial.actions.length, epsilon, state.stream)
  Object.assign(state, { action, explores, held: 0, bumped: false })
  drive(simulation, robot, trial.actions[action]!)
}

function conclude(state: TryState, simulation: Simulation, robot: number): void {
  const { trial, table, bumped, before, state: from, action } = state
  const now = sightOf(simulation, robot)
  const isNew = !state.tiles.includes(tileAt(now))
  if (isNew) state.tiles.push(tileAt(now))
  state.away = Math.max(state.away, distance(state.begun, now))
  const reward = payFor(trial.pay, factsOf(before!, now, bumped, isNew))
  const to = stateNow(state, simulation, robot)
  const ends = trial.bumpEnds && bumped
  const update = learn(table, trial.actions.length, settingsOf(trial), { from, action, reward, to, ends })
  const decision = state.explores ? 'explore' : 'exploit'
  state.last = { t: table.moves, from, action, decision, to, reward, ...update, ends }
  const { pay, bumps } = state.minute
  state.minute = { pay: pay + reward, bumps: bumps + Number(bumped && !before!.touches) }
  if (state.ticks >= longestTry && bumped && state.away < free) {
    state.stuck++
    state.stuckAt = state.start
  }
  Object.assign(state, { held: 0, before: now, state: ends || state.ticks >= longestTry ? -1 : to })
}

const distance = (a: Place, b: Place): number =>
  Math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y))

function turnMinute(state: TryState): void {
  state.curve.push(state.minute)
  state.minute = { pay: 0, bumps: 0 }
}

/** What it has learned so far. */
export const tableOf = ({ trial, table }: TryState): TableBrain => ({
  ...trial,
  kind: 'table',
  ...{ q: [...table.q], tries: [...table.tries], moves: table.moves },
})

/** The same with the minutes in which it was learned. */
export const learnedOf = (state: TryState): TableBrain => ({ ...tableOf(state), curve: [...state.curve] })
