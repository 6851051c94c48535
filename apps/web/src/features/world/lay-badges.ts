import type { RobotView } from '@botgarten/lab'
import { badgeSides, labelWidth, placeBadges, sizeOf, type Badge, type BadgeSides } from '#drawing/badges.ts'
import { boRadius } from '#drawing/grab.ts'
import type { Point, Size } from '#drawing/points.ts'
import { letters } from '#figures/letters.svelte.ts'

/** On a floor that is lower than this, in px, badges would hide what is on it. */
const least = 150
/** In px: the buttons in the upper corner, one of them on a small floor, that of the time in the lower corner, and the scale. */
const buttons = { one: 60, all: 158, height: 60 }
const scaleBar = { width: 170, height: 44 }
const reading = { width: 46, height: 28 }

/** Where a robot stands and what is round it, in px of the floor's box. */
interface Stands {
  readonly bo: Point
  readonly heading: number
  readonly tick: number
  readonly others: readonly Point[]
  /** Numbers at its rays. */
  readonly readings: readonly Point[]
  readonly viewport: { readonly pane: Size; readonly corner: Point; readonly scale: number }
}

const about = ({ x, y }: Point, { width, height }: Size) => ({
  ...{ x: x - width / 2, y: y - height / 2 },
  ...{ width, height },
})

function taken({ others, readings, viewport: { pane, corner, scale } }: Stands) {
  const [x, y] = [0 - corner.x, 0 - corner.y]
  const isSmall = pane.height < 280 || pane.width < 480
  const bo = { width: 2 * boRadius * scale, height: 2 * boRadius * scale }
  return [
    { x, y, width: isSmall ? buttons.one : buttons.all, height: buttons.height },
    { x, y: y + pane.height - buttons.height, width: buttons.one, height: buttons.height },
    { x: x + pane.width - scaleBar.width, y: y + pane.height - scaleBar.height, ...scaleBar },
    ...others.map((at) => about(at, bo)),
    ...readings.map((at) => about(at, reading)),
  ]
}

/** The side of each badge, and where and when the sides were chosen last. */
export interface BadgeMemory {
  readonly sides: BadgeSides
  last: Stands | null
}
export const badgeMemory = (): BadgeMemory => ({ sides: badgeSides(), last: null })

/** The robot was put elsewhere or back in time, or the floor is zoomed: it has not driven or turned here in small steps. */
function hasJumped(now: Stands, before: Stands): boolean {
  const { scale } = now.viewport
  const isFar = Math.hypot(now.bo.x - before.bo.x, now.bo.y - before.bo.y) > boRadius * scale
  return now.tick < before.tick || scale !== before.viewport.scale || isFar
}

/**
 * Badges with their boxes, and the room of their labels. A jump clears the memory, so that the picture of a robot at its start
 * does not depend on its drive before.
 */
export function layBadges(badges: readonly Badge[], stands: Stands, memory: BadgeMemory) {
  const { pane, corner, scale } = stands.viewport
  if (memory.last && hasJumped(stands, memory.last)) memory.sides.clear()
  memory.last = stands
  if (badges.length === 0 || pane.height < least) return []
  const widthOf = letters.widthOf.bind(letters)
  const around = {
    ...{ bo: stands.bo, heading: stands.heading, radius: boRadius * scale + 8 },
    area: { x: 0 - corner.x, y: 0 - corner.y, ...pane },
    taken: taken(stands),
  }
  const sizes = badges.map((badge) => ({ id: badge.id, ...sizeOf(badge, widthOf) }))
  const boxes = placeBadges(sizes, around, memory.sides)
  return badges.map((badge, i) => ({ badge, box: boxes[i]!, label: labelWidth(badge, widthOf) }))
}

/** The robots with the rays that are to be seen. @param ports null: of all sensors */
export function withRays(
  robots: readonly RobotView[],
  ports: readonly string[] | null,
): readonly RobotView[] {
  if (ports === null) return robots
  const some = ({ rays }: RobotView) =>
    Object.fromEntries(Object.entries(rays).filter(([port]) => ports.includes(port)))
  return robots.map((robot) => ({ ...robot, rays: some(robot) }))
}
