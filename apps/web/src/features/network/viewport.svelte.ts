import type { NetworkLayout } from '#drawing/network.ts'
import type { Point, Size } from '#drawing/points.ts'
import { sightOf, stepOf } from '#figures/network/deep/layout.ts'

/** What is seen of a network. Of a big one only that is drawn; panning is the compositor's. Px. */
export class Viewport {
  room: Size = $state.raw({ width: 0, height: 0 })
  /** From the stage's corner, in steps. */
  at: Point = $state.raw({ x: 0, y: 0 })

  look({ scrollLeft: x, scrollTop: y }: Element) {
    const next = stepOf({ x, y })
    if (next.x !== this.at.x || next.y !== this.at.y) this.at = next
  }

  sight({ stage }: NetworkLayout) {
    return sightOf(this.room, stage, this.at)
  }
}
