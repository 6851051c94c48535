import { drivesRoad, roadsToTry } from '@botgarten/experiments/roads'
import type { MapFile } from '@botgarten/maps'

export interface Asked {
  readonly map: MapFile
  /** Lines that were tried before. */
  readonly known: readonly string[]
  /** Of several workers each tries every so many'th road. */
  readonly part: { readonly index: number; readonly of: number }
}

/** A road that was tried, by its line. */
export interface Tried {
  readonly line: string
  readonly driven: boolean
}

let asked = 0

/** Between two roads a newer map may come, which ends the older one. */
self.onmessage = async ({ data: { map, known, part } }: MessageEvent<Asked>) => {
  const own = ++asked
  const roads = roadsToTry(map).filter((_, index) => index % part.of === part.index)
  for (const road of roads) {
    const line = map.roads[road.join('-')]!
    if (known.includes(line)) continue
    self.postMessage({ line, driven: drivesRoad(map, road) } satisfies Tried)
    await new Promise((next) => setTimeout(next))
    if (own !== asked) return
  }
}
