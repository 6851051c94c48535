import type { Lane, LaneKind, LaneResult } from '@botgarten/experiments/brain-race'
import { laneKinds, summariesOf } from '@botgarten/experiments/brain-race/table'
import type { Raced } from '@botgarten/programs'
import { Playback } from '../playback.svelte.ts'
import { saveRaced, type OpenCourse } from './ground.ts'
import { newWorker } from './new-worker.ts'
import type { Answered, Asked } from './worker.ts'

/** Places of a trail a second. */
const A_SECOND = 10
/** Dice of every race: the same brains race the same again. */
const SEED = 1

/** Both have no right answer. */
export const questions = ['trust', 'explain'] as const
type Question = (typeof questions)[number]

/** Which brains race, and the race that was run last. */
export class BrainRace {
  readonly open: OpenCourse
  /** Ids of projects of this device or of the class, whose best liked ones come first; '' for the brain of the course. */
  chosen = $state<{ readonly [kind in LaneKind]: string }>({ hand: '', examples: '', trying: '', ifThen: '' })
  /** 0..1 while it runs, else null. */
  share = $state<number | null>(null)
  /** The last race could not be run to its end, or could not be saved. */
  problem = $state<'failed' | 'notSaved' | null>(null)
  results = $state.raw<readonly LaneResult[]>([])
  answers = $state.raw<{ readonly [question in Question]?: LaneKind }>({})
  #raced = $state.raw<readonly Lane[]>([])
  /** The start that is shown, counted from 0. */
  #start = $state(0)
  readonly playback = new Playback()
  #worker: Worker | null = null

  constructor(open: OpenCourse) {
    this.open = open
    const { mine, own } = open
    for (const kind of laneKinds) this.choose(kind, own[kind].find(({ by }) => by !== undefined)?.id ?? '')
    if (mine?.kind) this.choose(mine.kind, mine.id)
    this.playback.speed = 1
  }

  readonly summaries = $derived.by(() => summariesOf(this.results, this.#raced))
  readonly isOver = $derived.by(() => this.results.length > 0)
  /** How many were ready and drove to the end. */
  readonly drove = $derived.by(() => this.results.filter(({ runs }) => runs).length)

  get start() {
    return this.#start
  }
  get second(): number {
    return this.playback.at / A_SECOND
  }

  choose(kind: LaneKind, id: string): void {
    this.chosen = { ...this.chosen, [kind]: id }
  }

  /** Shows another start, from its beginning. */
  show(start: number): void {
    this.#start = start
    this.playback.begin(A_SECOND * this.open.ground.course.seconds + 1)
  }

  #laneOf(kind: LaneKind): Lane {
    const { own, given } = this.open
    const mine = own[kind].find(({ id }) => id === this.chosen[kind])
    return { kind, racer: mine ? mine.racer : given[kind] }
  }

  /** From now on all brains are frozen. */
  async race(): Promise<void> {
    if (this.share !== null) return
    this.playback.stop()
    const lanes = laneKinds.map((kind) => this.#laneOf(kind))
    this.share = 0
    this.problem = null
    try {
      const results: LaneResult[] = []
      for (const [at, lane] of lanes.entries()) results.push(await this.#drive(lane, at / lanes.length))
      this.#raced = lanes
      this.results = results
      this.answers = {}
      this.show(0)
      await this.#save()
    } catch (cause) {
      console.warn('The race was not run to its end.', cause)
      this.problem = 'failed'
    }
    this.#end()
  }

  #drive(lane: Lane, from: number): Promise<LaneResult> {
    this.#worker ??= newWorker()
    const worker = this.#worker
    return new Promise((resolve, reject) => {
      worker.onerror = (event) => reject(new Error(event.message))
      worker.onmessage = ({ data: { done, result } }: MessageEvent<Answered>) => {
        this.share = from + done / laneKinds.length
        if (result) resolve(result)
      }
      const { ground } = this.open
      worker.postMessage({ ground, lane: $state.snapshot(lane), seed: SEED } satisfies Asked)
    })
  }

  async answer(question: Question, lane: LaneKind): Promise<void> {
    this.answers = { ...this.answers, [question]: lane }
    await this.#save()
  }

  /** The project that came along knows what came of it. */
  async #save(): Promise<void> {
    const { mine, ground } = this.open
    if (!mine) return
    const raced: Raced = { course: ground.course.id, brains: this.drove, ...this.answers }
    this.problem = (await saveRaced(mine.id, raced)) ? null : 'notSaved'
  }

  #end(): void {
    this.#worker?.terminate()
    this.#worker = null
    this.share = null
  }

  /** A race that is still running never ends. */
  close(): void {
    this.playback.stop()
    this.#end()
  }
}
