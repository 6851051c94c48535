import {
  createLearner,
  learnedPath,
  step,
  type LearnedPath,
  type QLearner,
  type QWorld,
} from '@botgarten/learning/q-learning'
import { fastDraw, fastStream, stream } from '@botgarten/numbers'
import { settingsOf } from '@botgarten/experiments/race'
import { laneOf } from './lanes.ts'
import { distinct } from './room.ts'
import type { Track } from './track.ts'
import type { Tried } from './walked.ts'

/** Number of tries of the user, and of Bo before its table is shown. */
const TRIES = 3
/** Number of tries by which Bo goes on when the user asks for it. */
export const MORE = 20
const SEED = 1

/** Where the child stands. */
interface Here {
  readonly state: number
  readonly from: number | null
  readonly fell: boolean
}

/** A door of a room: an action of its state. */
export interface Door {
  readonly action: number
  readonly to: number
  /** Its side if the map is a grid, such as `left`. */
  readonly side: string | null
}

/** The part of Bo's tries on the screen after the user's last try. */
export interface Learned {
  readonly tries: readonly Tried[]
  readonly way: LearnedPath
  readonly q: readonly number[]
}

/** The user walks through a map and sees as much as Bo: the current room, its doors, and own notes. Bo learns on the same map. */
export class WalkModel {
  readonly track: Track
  here = $state.raw<Here>({ state: 0, from: null, fell: false })
  /** Tries that are over. */
  tries = $state.raw<readonly Tried[]>([])
  /** The current try. */
  now = $state.raw<Tried>(nothing(0))
  /** 0..5 stars by action. */
  notes = $state.raw<readonly number[]>([])
  /** Actions in the order they were first taken. */
  taken = $state.raw<readonly number[]>([])
  /** The action that the user has to rate with stars. */
  asked = $state<number | null>(null)
  answer = $state('')
  /** Between two tries: doors are closed, notes are open. */
  rests = $state(false)
  learned = $state.raw<Learned | null>(null)
  #dice = fastStream(stream(SEED, 'race/me/1'))
  #bo: QLearner
  #boTries: Tried[] = []

  constructor(track: Track) {
    this.track = track
    this.#bo = this.#learner()
    this.begin()
  }

  /** Has the user gone through a door? */
  get hasBegun() {
    return this.taken.length > 0
  }
  get isOver() {
    return this.tries.length >= TRIES
  }
  get count() {
    return TRIES
  }
  /** Rooms that were seen. */
  get rooms(): readonly number[] {
    const { from, leads } = this.track.world
    const known = this.taken.flatMap((action) => [from[action]!, leads[action]!])
    return distinct([this.track.world.start, ...known, ...this.now.states]).toSorted((a, b) => a - b)
  }

  doorsOf(state: number): readonly Door[] {
    const { first, meant, names } = this.track.world
    return Array.from({ length: first[state + 1]! - first[state]! }, (_, index) => {
      const action = first[state]! + index
      const side = names[action]!.slice(`${state}-`.length)
      return { action, to: meant[action]!, side: /^\d+$/.test(side) ? null : side }
    })
  }

  /** From the beginning, with empty notes. */
  begin(): void {
    const { world } = this.track
    this.#dice = fastStream(stream(SEED, 'race/me/1'))
    this.#bo = this.#learner()
    this.#boTries = []
    this.tries = []
    this.taken = []
    this.notes = world.names.map(() => 0)
    this.asked = null
    this.learned = null
    this.answer = ''
    this.#return()
  }

  /** Back at the start, for the next try. */
  next(): void {
    if (this.rests) this.#return()
  }

  #learner(): QLearner {
    const settings = settingsOf(laneOf('q'))
    return createLearner(this.track.world, settings, stream(SEED, 'race/bo/1'))
  }

  #return(): void {
    const { start } = this.track.world
    this.rests = false
    this.now = nothing(start)
    this.here = { state: start, from: null, fell: false }
  }

  /** Through a door. */
  take(action: number): void {
    if (this.isOver || this.rests) return
    const { world } = this.track
    const end = outcomeOf(world, action, this.#dice)
    const [to, fell] = [world.to[end]!, world.isFall[end] === 1]
    this.taken = distinct([...this.taken, action])
    this.asked = action
    this.now = {
      states: [...this.now.states, to],
      stars: this.now.stars + world.reward[end]!,
      falls: this.now.falls + (fell ? 1 : 0),
      atGoal: world.isGoal[to] === 1,
    }
    this.here = { state: to, from: world.from[action]!, fell }
    if (this.#ends(to)) this.#finish()
  }

  /** As an attempt of the standard rules ends: at a goal, in a hole, at a dead end, or after 20 × stations moves. */
  #ends(to: number): boolean {
    const { terminal, first, states } = this.track.world
    return terminal[to] === 1 || first[to] === first[to + 1] || this.now.states.length > 20 * states
  }

  #finish(): void {
    this.tries = [...this.tries, this.now]
    this.#boTries.push(oneTry(this.#bo))
    if (this.isOver) this.#show()
    else this.rests = true
  }

  #show(): void {
    this.learned = {
      ...{ tries: [...this.#boTries], way: learnedPath(this.#bo), q: [...this.#bo.q] },
    }
  }

  /** Lets Bo make more tries than the user has made. */
  letBoGoOn(): void {
    for (let count = 0; count < MORE; count++) this.#boTries.push(oneTry(this.#bo))
    this.#show()
  }

  note(action: number, stars: number): void {
    this.notes = this.notes.with(action, stars)
    this.asked = action
  }
}

const nothing = (start: number): Tried => ({ states: [start], stars: 0, falls: 0, atGoal: false })

function outcomeOf(world: QWorld, action: number, dice: ReturnType<typeof fastStream>): number {
  let end = world.outcome[action]!
  const last = world.outcome[action + 1]! - 1
  if (end === last) return end
  const drawn = fastDraw(dice)
  while (end < last && drawn >= world.upTo[end]!) end++
  return end
}

/** Makes the next try of a learner and returns it in the form of the user's tries. */
function oneTry(learner: QLearner): Tried {
  let tried: Tried | null = null
  const { episodes } = learner
  while (learner.episodes === episodes) {
    const { from, to, reward } = step(learner)
    tried ??= nothing(from)
    tried = {
      states: [...tried.states, to],
      stars: tried.stars + reward,
      falls: tried.falls + (learner.last.fell ? 1 : 0),
      atGoal: learner.world.isGoal[to] === 1,
    }
  }
  return tried ?? nothing(learner.world.start)
}
