import { stream } from '@botgarten/numbers'
import { createLearner, restoreLearner, saveLearner, type QLearner } from './learner.ts'
import { learnedPath, type LearnedPath } from './learned.ts'
import { run, step } from './step.ts'
import type { QState, QTrace, Settings } from './types.ts'
import type { QWorld } from './world.ts'

/** Steps between two kept states, at first. */
const EVERY = 500
/** More kept states than these: every other one goes, and twice as many steps lie between them. */
const MOST = 400

export interface Limits {
  readonly episodes: number
  readonly steps: number
}

/** One episode, when it was over. */
export interface Episode {
  readonly reward: number
  readonly steps: number
  /** Its last step, counted from the beginning. */
  readonly end: number
  readonly atGoal: boolean
  /** Sections of the way that was learned then; null: there was none. */
  readonly best: number | null
}

/** From this episode, and this step, on the learned way was this one; null: none. */
interface Turn {
  readonly episode: number
  readonly step: number
  readonly way: string | null
}

/** The dice of a course: the lab and the command line learn the same from the same seed. */
export const courseStream = (seed: number) => stream(seed, 'learn/playground')

/**
 * One learning from its seed on, at which one can look at any step. The same world, settings and seed are the same
 * course, bit for bit: what lies behind the step that is shown is not lost when one goes back.
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
  #before = { steps: 0, goals: 0 }

  constructor(world: QWorld, settings: Settings, seed: number, limits: Limits) {
    this.learner = createLearner(world, settings, courseStream(seed))
    this.limits = limits
    this.#kept = [saveLearner(this.learner)]
  }

  /** The step that is shown, counted from 1; 0: nothing is learned yet. */
  get shown(): number {
    return this.learner.steps
  }

  /** How far it has come. */
  get made(): number {
    return this.#made
  }

  /** The step that is shown, opened; null at the beginning and where it was not asked for. */
  get trace(): QTrace | null {
    return this.#trace
  }

  /** Which limit stopped it; null: it can go on. */
  get over(): 'episodes' | 'steps' | null {
    const { episodes, steps } = this.learner
    if (episodes >= this.limits.episodes) return 'episodes'
    return steps >= this.limits.steps ? 'steps' : null
  }

  /** The next step, opened. Null when it is over. */
  next(): QTrace | null {
    if (this.over) return null
    this.#trace = step(this.learner)
    this.#note()
    return this.#trace
  }

  /** So many steps, the last of them opened. Returns how many were made before a limit stopped it. */
  advance(steps: number): number {
    const from = this.shown
    const until = Math.min(from + steps, this.limits.steps) - 1
    while (this.shown < until && !this.over) {
      run(this.learner, Math.min(until, this.#nextKept()) - this.shown, 1)
      this.#note()
    }
    if (this.shown < from + steps) this.next()
    // Where a limit stopped it the last step was not opened yet.
    if (this.shown > from && this.#trace?.t !== this.shown) this.goTo(this.shown)
    return this.shown - from
  }

  /** Shows a step of what has been: 0 is the beginning. */
  goTo(t: number): void {
    const wanted = Math.max(0, Math.min(t, this.#made))
    const saved =
      this.#kept[Math.min(Math.floor(Math.max(0, wanted - 1) / this.#every), this.#kept.length - 1)]!
    restoreLearner(this.learner, saved)
    this.#trace = null
    run(this.learner, wanted - 1 - saved.steps)
    if (wanted > 0) this.#trace = step(this.learner)
  }

  /** What is learned at the step that is shown. */
  way(): LearnedPath {
    return learnedPath(this.learner)
  }

  /** The episode, counted from 1, in which the way was found that is the learned one at the step that is shown. */
  foundIn(): number | null {
    return this.#found()?.episode ?? null
  }

  /** The last step of that episode. */
  foundAt(): number | null {
    return this.#found()?.step ?? null
  }

  #found(): Turn | null {
    const turn = this.#turns.findLast(({ episode }) => episode <= this.learner.episodes)
    // Within an episode another way may already be the learned one.
    return turn?.way != null && turn.way === nameOf(this.way()) ? turn : null
  }

  /** Steps at which the next state is kept. */
  #nextKept = () => (Math.floor(this.shown / this.#every) + 1) * this.#every

  /** Only what happens for the first time is written down. */
  #note(): void {
    const { learner } = this
    if (learner.steps <= this.#made) return
    this.#made = learner.steps
    if (learner.episodes > this.episodes.length) this.#noteEpisode()
    if (learner.steps % this.#every === 0) this.#keep()
  }

  #noteEpisode(): void {
    const { steps, goals, world, episodes } = this.learner
    const learned = this.way()
    const way = learned.states
    const atGoal = goals > this.#before.goals
    this.episodes.push({
      reward: (goals - this.#before.goals) * (world.task.goalReward ?? 50),
      steps: steps - this.#before.steps,
      end: steps,
      atGoal,
      best: way ? way.length - 1 : null,
    })
    this.#before = { steps, goals }
    const name = nameOf(learned)
    if (name !== (this.#turns.at(-1)?.way ?? null))
      this.#turns.push({ episode: episodes, step: steps, way: name })
  }

  #keep(): void {
    this.#kept.push(saveLearner(this.learner))
    if (this.#kept.length <= MOST) return
    this.#kept = this.#kept.filter((_, index) => index % 2 === 0)
    this.#every *= 2
  }
}

const nameOf = ({ states }: LearnedPath) => states?.join('-') ?? null

/**
 * 0..5 in halves: an action's value as a share of the reward of the goal, or of the highest value if that is more. An action
 * that has paid at all has half a star.
 */
export function starsOf({ q, world }: Pick<QLearner, 'q' | 'world'>, value: number): number {
  let most = world.task.goalReward ?? 50
  for (const other of q) if (other > most) most = other
  return most > 0 && value > 0 ? Math.min(5, Math.max(1, Math.round((10 * value) / most)) / 2) : 0
}

/** Has the robot been there? */
export function visited({ world, tries, steps }: QLearner): boolean[] {
  const seen = Array.from({ length: world.states }, (_, state) => steps > 0 && state === world.start)
  for (let action = 0; action < tries.length; action++)
    if (tries[action]! > 0) seen[world.from[action]!] = seen[world.meant[action]!] = true
  return seen
}
