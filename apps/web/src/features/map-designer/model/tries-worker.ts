import { drivesRoad, roadsToTry } from '@botgarten/experiments/roads'
import type { MapFile } from '@botgarten/maps'

export interface Asked {
  readonly map: MapFile
  /** Lines that were tried before. */
  readonly known: readonly string[]
}

/** A road that was tried, by its line. */
export interface Tried {
  readonly line: string
  readonly driven: boolean
}

let asked = 0

/** Between two roads a newer map may come, which ends the older one. */
self.onmessage = async ({ data: { map, known } }: MessageEvent<Asked>) => {
  const own = ++asked
  for (const road of roadsToTry(map)) {
    const line = map.roads[road.join('-')]!
    if (known.includes(line)) continue
    self.postMessage({ line, driven: drivesRoad(map, road) } satisfies Tried)
    await new Promise((next) => setTimeout(next))
    if (own !== asked) return
  }
}
