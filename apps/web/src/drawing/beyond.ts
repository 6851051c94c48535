import type { Obstacle } from '@botgarten/simulation'
import { onFloor } from './camera.ts'
import type { Command } from './commands.ts'
import { clamp, type Point, type Size } from './points.ts'
import { drawThing } from './thing-looks.ts'
import { radiusOf } from './things.ts'
import type { Placed, Scene } from './world.ts'

const paper = '#FFFDF8'
const ink = '#4A3428'
/** Px from the edge of what is seen to the middle of a sign. */
const inset = 30
const radius = 15
/** Px: in the upper left corner is the button that shows the whole floor. */
const taken = 60

/**
 * Signs at the edge for robots that stand beyond it, and for the nearest thing where none is seen: each points to
 * where that is. None for what is seen.
 */
export const drawBeyond = (
  scene: Pick<Scene, 'view' | 'things' | 'floor' | 'scale' | 'seen' | 'colours'>,
): readonly Command[] => {
  const { view, floor, scale, seen, colours } = scene
  const thing = nearestBeyond(scene)
  return [
    ...view.robots.flatMap(({ pose }, index) => {
      const at = onFloor(pose, floor, scale)
      const face = numbered(colours[index % colours.length]!, index + 1)
      return isSeen(at, seen, 0) ? [] : [sign(at, seen, face)]
    }),
    ...(thing ? [sign(onFloor(thing.pose, floor, scale), seen, small(thing.thing))] : []),
  ]
}

const isSeen = ({ x, y }: Point, seen: Size & Point, radius: number): boolean =>
  x > seen.x - radius &&
  y > seen.y - radius &&
  x < seen.x + seen.width + radius &&
  y < seen.y + seen.height + radius

/** The thing that is nearest to the first robot, where nothing is seen of any. */
function nearestBeyond({
  view,
  things,
  floor,
  scale,
  seen,
}: Pick<Scene, 'view' | 'things' | 'floor' | 'scale' | 'seen'>): Placed | null {
  const shown = ({ pose, thing }: Placed) =>
    isSeen(onFloor(pose, floor, scale), seen, radiusOf(thing.shape) * 0.6 * scale)
  const robot = view.robots[0]
  if (!robot || things.length === 0 || things.some(shown)) return null
  const away = ({ pose }: Placed) => Math.hypot(pose.x - robot.pose.x, pose.y - robot.pose.y)
  return things.reduce((best, one) => (away(one) < away(best) ? one : best))
}

/** The number of a robot on its colour. */
const numbered = (fill: string, number: number): readonly Command[] => [
  { kind: 'circle', x: 0, y: 0, r: radius, fill, stroke: ink, lineWidth: 3 },
  {
    ...{ kind: 'text', text: String(number), x: 0, y: 5.5, size: 16, font: 'title', align: 'middle' },
    fill: ink,
  },
]

/** A thing as large as fits into a sign. */
const small = (thing: Obstacle): readonly Command[] => [
  { kind: 'circle', x: 0, y: 0, r: radius, fill: paper, stroke: ink, lineWidth: 3 },
  { kind: 'group', scale: (radius - 4) / radiusOf(thing.shape), shapes: drawThing(thing) },
]

function sign({ x, y }: Point, seen: Size & Point, face: readonly Command[]): Command {
  const at = {
    x: clamp(x, seen.x + inset, seen.x + seen.width - inset),
    y: clamp(y, seen.y + inset, seen.y + seen.height - inset),
  }
  if (at.x < seen.x + taken && at.y < seen.y + taken) at.x = seen.x + taken + inset
  const length = Math.hypot(x - at.x, y - at.y)
  const [dx, dy] = [(x - at.x) / length, (y - at.y) / length]
  const point = (along: number, across: number) => ({
    x: dx * along - dy * across,
    y: dy * along + dx * across,
  })
  return {
    kind: 'group',
    ...at,
    shapes: [
      {
        kind: 'line',
        points: [point(12, -10), point(radius + 12, 0), point(12, 10)],
        closed: true,
        fill: ink,
        stroke: paper,
        lineWidth: 2,
      },
      ...face,
    ],
  }
}
