import type { Input } from '../types.ts'

/** Ten simulated minutes, in ticks. */
const LONGEST = 10 * 60 * 60

/**
 * What is needed to come back to any moment of a run: keyframes of plain data and the inputs by tick (running.md 2, 8, 9).
 * What is older than ten simulated minutes is forgotten.
 */
export class Timeline<Keyframe extends { readonly tick: number }> {
  #keyframes: Keyframe[] = []
  #inputs = new Map<number, Input[]>()

  keep(keyframe: Keyframe): void {
    this.#keyframes.push(keyframe)
    const oldest = keyframe.tick - LONGEST
    while (this.#keyframes.length > 1 && this.#keyframes[1]!.tick <= oldest) this.#keyframes.shift()
    const first = this.#keyframes[0]!.tick
    for (const tick of this.#inputs.keys()) if (tick < first) this.#inputs.delete(tick)
  }

  /** Notes an input that was given before `tick` ran. */
  log(tick: number, input: Input): void {
    const inputs = this.#inputs.get(tick)
    if (inputs) inputs.push(input)
    else this.#inputs.set(tick, [input])
  }

  inputsAt(tick: number): readonly Input[] {
    return this.#inputs.get(tick) ?? []
  }

  /** The last keyframe at or before a tick; undefined before the first. */
  before(tick: number): Keyframe | undefined {
    return this.#keyframes.findLast((keyframe) => keyframe.tick <= tick)
  }
}
