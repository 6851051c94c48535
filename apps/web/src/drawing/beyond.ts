import { onFloor } from './camera.ts'
import type { Command } from './commands.ts'
import { clamp, type Point, type Size } from './points.ts'
import type { Scene } from './world.ts'

const paper = '#FFFDF8'
const ink = '#4A3428'
/** Px from the edge of what is seen to the middle of a sign. */
const inset = 30
const radius = 15
/** Px: in the upper left corner is the button that shows the whole floor. */
const taken = 60

/**
 * Signs at the edge for robots that stand beyond it: each points to where its robot is. None for one that is seen.
 * @param seen what is seen of the floor, in px of its box
 */
export const drawBeyond = (
  { view, floor, scale, colours }: Pick<Scene, 'view' | 'floor' | 'scale' | 'colours'>,
  seen: Size & Point,
): readonly Command[] =>
  view.robots.flatMap(({ pose }, index) => {
    const at = onFloor(pose, floor, scale)
    return isSeen(at, seen) ? [] : [sign(at, seen, colours[index % colours.length]!, index + 1)]
  })

const isSeen = ({ x, y }: Point, seen: Size & Point): boolean =>
  x > seen.x && y > seen.y && x < seen.x + seen.width && y < seen.y + seen.height

function sign({ x, y }: Point, seen: Size & Point, colour: string, number: number): Command {
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
      { kind: 'circle', x: 0, y: 0, r: radius, fill: colour, stroke: ink, lineWidth: 3 },
      {
        ...{ kind: 'text', text: String(number), x: 0, y: 5.5, size: 16, font: 'title', align: 'middle' },
        fill: ink,
      },
    ],
  }
}
