import type { RobotView } from '@botgarten/lab'
import type { Viewport } from '#figures/world/viewport.svelte.ts'

type Side = 'left' | 'right'

/** Px from the upper corner that the buttons cover, a low or narrow floor's one button and a large one's three. */
const covered = { height: 60, few: 60, all: 160, narrow: 560, low: 280 }
/** From the middle of a robot to its rim, in cm. */
const reach = 12

/**
 * In which upper corner the buttons stand: where they stood, until a robot is under them and none is in the other
 * corner. It remembers where that was.
 */
export function buttonSide() {
  let side: Side = 'left'
  return (
    robots: readonly Pick<RobotView, 'pose'>[],
    { pane, scale, corner }: Pick<Viewport, 'pane' | 'scale' | 'corner'>,
    floorHeight: number,
  ): Side => {
    const narrow = pane.width < covered.narrow || pane.height < covered.low
    const width = (narrow ? covered.few : covered.all) + reach * scale
    const isTaken = (one: Side) =>
      robots.some(({ pose }) => {
        const x = pose.x * scale + corner.x
        const y = (floorHeight - pose.y) * scale + corner.y
        return y < covered.height + reach * scale && (one === 'left' ? x < width : x > pane.width - width)
      })
    const other = side === 'left' ? 'right' : 'left'
    if (isTaken(side) && !isTaken(other)) side = other
    return side
  }
}
