import { readMap } from '@botgarten/maps'
import { setDress, writeMap } from '@botgarten/maps/own'
import type { RoadMap } from '@botgarten/programs'
import { newWorker } from './new-worker.ts'
import type { Asked, Tried } from './tries-worker.ts'

/** A hand that goes on within this time is not done yet, in ms. */
const CALM = 600

/** As many as the smallest computers of a school have cores. */
const WORKERS = 2

/** Bo tries all roads of a map, in both directions, in workers; after every change the roads that changed. */
export class RoadTries {
  /** By the line of a road: did Bo get to its end? */
  #driven = $state.raw<{ readonly [line: string]: boolean }>({})
  #lines: readonly string[] = $state.raw([])
  #workers: readonly Worker[] = []
  #timer: ReturnType<typeof setTimeout> | undefined

  /** How many roads there are, each direction for itself. */
  get all() {
    return this.#lines.length
  }
  get tried() {
    return this.#lines.filter((line) => line in this.#driven).length
  }
  /** Roads that Bo drove to their end. */
  get driven() {
    return this.#lines.filter((line) => this.#driven[line]).length
  }

  follow(map: RoadMap): void {
    const text = writeMap(setDress(map, 'paper'), 'tried')
    this.#lines = [...text.matchAll(/<path id="path-\d+-\d+" d="([^"]*)"/g)].map(([, line]) => line!)
    clearTimeout(this.#timer)
    if (this.#lines.every((line) => line in this.#driven)) return
    this.#timer = setTimeout(() => this.#ask(text), CALM)
  }

  #ask(text: string): void {
    const { map } = readMap(text)
    if (!map) return
    if (this.#workers.length === 0) this.#workers = Array.from({ length: WORKERS }, this.#hired)
    const known = Object.keys(this.#driven)
    this.#workers.forEach((worker, index) =>
      worker.postMessage({ map, known, part: { index, of: WORKERS } } satisfies Asked),
    )
  }

  #hired = (): Worker => {
    const worker = newWorker()
    worker.onmessage = ({ data }: MessageEvent<Tried>) =>
      (this.#driven = { ...this.#driven, [data.line]: data.driven })
    return worker
  }

  close(): void {
    clearTimeout(this.#timer)
    for (const worker of this.#workers) worker.terminate()
  }
}
