import { stream } from '@botgarten/numbers'
import { createLearner, restoreLearner, saveLearner, type QLearner } from './learner.ts'
import { learnedWay, type LearnedWay } from './learned.ts'
import { run, step } from './step.ts'
import type { QState, QTrace, Settings } from './types.ts'
import type { QWorld } from './world.ts'

/** Moves between two kept states, at first. */
const EVERY = 500
/** More kept states than these: every other one goes, and twice as many moves lie between them. */
const MOST = 400

export interface Limits {
  readonly episodes: number
  readonly moves: number
}

/** One episode, when it was over. */
export interface Episode {
  readonly reward: number
  readonly moves: number
  /** Its last move, counted from the beginning. */
  readonly end: number
  readonly atGoal: boolean
  /** Sections of the way that was learned then; null: there was none. */
  readonly best: number | null
}

/** From this episode, and this move, on the learned way was this one; null: none. */
interface Turn {
  readonly episode: number
  readonly move: number
  readonly way: string | null
}

/** The dice of a course: the lab and the command line learn the same from the same seed. */
export const courseStream = (seed: number) => stream(seed, 'learn/playground')

/**
 * One learning from its seed on, at which one can look at any move. The same world, settings and seed are the same
 * course, bit for bit: what lies behind the move that is shown is not lost when one goes back.
 */
export class Course {
  readonly learner: QLearner
  readonly limits: Limits
  /** All episodes that have ended so far. */
  readonly episodes: Episode[] = []
  #trace: QTrace | null = null
  #made = 0
  #every = EVERY
  #kept: QState[]
  #turns: Turn[] = []
  #before = { moves: 0, goals: 0 }

  constructor(world: QWorld, settings: Settings, seed: number, limits: Limits) {
    this.learner = createLearner(world, settings, courseStream(seed))
    this.limits = limits
    this.#kept = [saveLearner(this.learner)]
  }

  /** The move that is shown, counted from 1; 0: nothing is learned yet. */
  get shown(): number {
    return this.learner.moves
  }

  /** How far it has come. */
  get made(): number {
    return this.#made
  }

  /** The move that is shown, opened; null at the beginning and where it was not asked for. */
  get trace(): QTrace | null {
    return this.#trace
  }

  /** Which limit stopped it; null: it can go on. */
  get over(): 'episodes' | 'moves' | null {
    const { episodes, moves } = this.learner
    if (episodes >= this.limits.episodes) return 'episodes'
    return moves >= this.limits.moves ? 'moves' : null
  }

  /** The next move, opened. Null when it is over. */
  next(): QTrace | null {
    if (this.over) return null
    this.#trace = step(this.learner)
    this.#note()
    return this.#trace
  }

  /** So many moves, the last of them opened. Returns how many were made before a limit stopped it. */
  advance(moves: number): number {
    const from = this.shown
    const until = Math.min(from + moves, this.limits.moves) - 1
    while (this.shown < until && !this.over) {
      run(this.learner, Math.min(until, this.#nextKept()) - this.shown, 1)
      this.#note()
    }
    if (this.shown < from + moves) this.next()
    // Where a limit stopped it the last move was not opened yet.
    if (this.shown > from && this.#trace?.t !== this.shown) this.goTo(this.shown)
    return this.shown - from
  }

  /** Shows a move of what has been: 0 is the beginning. */
  goTo(move: number): void {
    const wanted = Math.max(0, Math.min(move, this.#made))
    const state =
      this.#kept[Math.min(Math.floor(Math.max(0, wanted - 1) / this.#every), this.#kept.length - 1)]!
    restoreLearner(this.learner, state)
    this.#trace = null
    run(this.learner, wanted - 1 - state.moves)
    if (wanted > 0) this.#trace = step(this.learner)
  }

  /** What is learned at the move that is shown. */
  way(): LearnedWay {
    return learnedWay(this.learner)
  }

  /** The episode, counted from 1, in which the way was found that is the learned one at the move that is shown. */
  foundIn(): number | null {
    return this.#found()?.episode ?? null
  }

  /** The last move of that episode. */
  foundAt(): number | null {
    return this.#found()?.move ?? null
  }

  #found(): Turn | null {
    const turn = this.#turns.findLast(({ episode }) => episode <= this.learner.episodes)
    // Within an episode another way may already be the learned one.
    return turn?.way != null && turn.way === nameOf(this.way()) ? turn : null
  }

  /** Moves at which the next state is kept. */
  #nextKept = () => (Math.floor(this.shown / this.#every) + 1) * this.#every

  /** Only what happens for the first time is written down. */
  #note(): void {
    const { learner } = this
    if (learner.moves <= this.#made) return
    this.#made = learner.moves
    if (learner.episodes > this.episodes.length) this.#noteEpisode()
    if (learner.moves % this.#every === 0) this.#keep()
  }

  #noteEpisode(): void {
    const { moves, goals, world, episodes } = this.learner
    const learned = this.way()
    const way = learned.stations
    const atGoal = goals > this.#before.goals
    this.episodes.push({
      reward: (goals - this.#before.goals) * (world.task.goalReward ?? 50),
      moves: moves - this.#before.moves,
      end: moves,
      atGoal,
      best: way ? way.length - 1 : null,
    })
    this.#before = { moves, goals }
    const name = nameOf(learned)
    if (name !== (this.#turns.at(-1)?.way ?? null))
      this.#turns.push({ episode: episodes, move: moves, way: name })
  }

  #keep(): void {
    this.#kept.push(saveLearner(this.learner))
    if (this.#kept.length <= MOST) return
    this.#kept = this.#kept.filter((_, index) => index % 2 === 0)
    this.#every *= 2
  }
}

const nameOf = ({ stations }: LearnedWay) => stations?.join('-') ?? null

/** 0..5: how good a move is beside the best one that is known. */
export function starsOf({ q }: Pick<QLearner, 'q'>, value: number): number {
  let highest = 0
  for (const other of q) if (other > highest) highest = other
  return highest > 0 && value > 0 ? Math.min(5, Math.round((5 * value) / highest)) : 0
}

/** Has the robot been there? */
export function visited({ world, tries, moves }: QLearner): boolean[] {
  const seen = Array.from({ length: world.stations }, (_, station) => moves > 0 && station === world.start)
  for (let move = 0; move < tries.length; move++)
    if (tries[move]! > 0) seen[world.from[move]!] = seen[world.meant[move]!] = true
  return seen
}
