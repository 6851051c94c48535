import { readMap } from '@botgarten/maps'
import { lineOf, setDress, writeMap } from '@botgarten/maps/own'
import type { MapRoad, RoadMap } from '@botgarten/programs'
import { newWorker } from './new-worker.ts'
import type { Asked, Tried } from './tries-worker.ts'

/** A hand that goes on within this time is not done yet, in ms. */
const CALM = 600

/** As many as the smallest computers of a school have cores. */
const WORKERS = 2

/** Lines of a road in the directions that are open. */
function openLines(map: RoadMap, road: MapRoad): readonly string[] {
  const { there, back } = lineOf(map, road)
  const isOpen = (way: 'there' | 'back') => road.closed !== 'both' && road.closed !== way
  return [...(isOpen('there') ? [there] : []), ...(!road.oneWay && isOpen('back') ? [back] : [])]
}

/** Bo tries all roads of a map, in both directions, in workers; after every change the roads that changed. */
export class RoadTries {
  /** By the line of a road: did Bo get to its end? */
  #driven = $state.raw<{ readonly [line: string]: boolean }>({})
  /** By road that is open: its lines. */
  #roads: readonly (readonly string[])[] = $state.raw([])
  #workers: readonly Worker[] = []
  #timer: ReturnType<typeof setTimeout> | undefined

  /** How many roads are open, in one direction or both. */
  get all() {
    return this.#roads.length
  }
  get tried() {
    return this.#roads.filter((lines) => lines.every((line) => line in this.#driven)).length
  }
  /** Roads that Bo drove to their end in each direction that is open. */
  get driven() {
    return this.#roads.filter((lines) => lines.every((line) => this.#driven[line])).length
  }

  follow(map: RoadMap): void {
    const onPaper = setDress(map, 'paper')
    this.#roads = onPaper.roads.map((road) => openLines(onPaper, road)).filter(({ length }) => length > 0)
    clearTimeout(this.#timer)
    if (this.tried === this.all) return
    this.#timer = setTimeout(() => this.#ask(writeMap(onPaper, 'tried')), CALM)
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
