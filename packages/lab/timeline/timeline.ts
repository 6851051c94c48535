import type { Input } from '../inputs/input.ts'
import type { Mark } from '../types.ts'

/** Ten simulated minutes, in ticks. */
const LONGEST = 10 * 60 * 60
/** Marks of one kind that are nearer to each other than this (ticks) are one. */
const PAUSE = 60

/** Inputs that leave a mark on the line of time. */
const markOf: { readonly [kind in Input['kind']]?: Mark['kind'] } = {
  ...{ place: 'place', weight: 'weight', brain: 'weight', button: 'weight' },
}

/** An input as it was given: before its tick ran, after so many steps from block to block inside it. */
export interface Given {
  readonly part: number
  readonly input: Input
}

/**
 * What is needed to come back to any moment of a run: keyframes of plain data and the inputs by tick (running.md 2, 8, 9).
 * What is older than ten simulated minutes is forgotten.
 */
export class Timeline<Keyframe extends { readonly tick: number }> {
  #keyframes: Keyframe[] = []
  #inputs = new Map<number, Given[]>()
  #marks: readonly Mark[] = []

  /** Tick of the oldest moment there is a way back to. */
  get first(): number {
    return this.#keyframes[0]?.tick ?? 0
  }

  get last(): Keyframe | undefined {
    return this.#keyframes.at(-1)
  }

  /** What a hand has changed. The same array until there is more. */
  get marks(): readonly Mark[] {
    return this.#marks
  }

  keep(keyframe: Keyframe): void {
    this.#keyframes.push(keyframe)
    const oldest = keyframe.tick - LONGEST
    const before = this.first
    while (this.#keyframes.length > 1 && this.#keyframes[1]!.tick <= oldest) this.#keyframes.shift()
    if (this.first > before) this.#forget(this.first)
  }

  #forget(first: number): void {
    // Inputs come in order of time.
    for (const tick of this.#inputs.keys()) {
      if (tick >= first) break
      this.#inputs.delete(tick)
    }
    if ((this.#marks[0]?.to ?? first) < first) this.#marks = this.#marks.filter(({ to }) => to >= first)
  }

  /** Notes an input that was given before `tick` ran. With `instead` it stands for the one before, which then had no effect. */
  log(tick: number, given: Given, instead: boolean): void {
    const inputs = this.#inputs.get(tick)
    if (!inputs) this.#inputs.set(tick, [given])
    else if (instead) inputs[inputs.length - 1] = given
    else inputs.push(given)
    const mark = markOf[given.input.kind]
    if (mark) this.#mark(tick, mark)
  }

  #mark(tick: number, kind: Mark['kind']): void {
    const last = this.#marks.at(-1)
    if (last?.kind !== kind || tick - last.to >= PAUSE)
      this.#marks = [...this.#marks, { kind, from: tick, to: tick }]
    else if (tick > last.to) this.#marks = [...this.#marks.slice(0, -1), { ...last, to: tick }]
  }

  inputsAt(tick: number): readonly Given[] {
    return this.#inputs.get(tick) ?? []
  }

  /** The last keyframe at or before a tick; undefined before the first. */
  before(tick: number): Keyframe | undefined {
    return this.#keyframes.findLast((keyframe) => keyframe.tick <= tick)
  }

  /** The same time up to a tick, and the first `given` inputs of that tick. Shares no list with this one. */
  until(tick: number, given: number): Timeline<Keyframe> {
    const past = new Timeline<Keyframe>()
    past.#keyframes = this.#keyframes.filter((keyframe) => keyframe.tick <= tick)
    for (const [at, inputs] of this.#inputs) {
      const kept = at < tick ? inputs.slice() : at === tick ? inputs.slice(0, given) : []
      if (kept.length > 0) past.#inputs.set(at, kept)
    }
    past.#marks = this.#marks
      .filter(({ from }) => from < tick || (from === tick && given > 0))
      .map((mark) => (mark.to > tick ? { ...mark, to: tick } : mark))
    return past
  }
}
