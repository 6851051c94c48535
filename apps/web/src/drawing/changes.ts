import type { Command } from './commands.ts'
import type { Point, Size } from './points.ts'

/** A group that is painted as a picture, and what it covers. */
interface Picture extends Size, Point {
  readonly shapes: readonly Command[]
  readonly opacity: number
}

/**
 * What has to be painted again where `after` follows on `before`, in their units; null: all of it, since something else than
 * pictures is among them, or one is turned or scaled, or there are more or fewer.
 */
export function changes(
  before: readonly Command[],
  after: readonly Command[],
): readonly (Size & Point)[] | null {
  const [was, is] = [pictures(before), pictures(after)]
  if (!was || !is || was.length !== is.length) return null
  return is.flatMap((picture, i) => (same(picture, was[i]!) ? [] : [was[i]!, picture]))
}

/** In the order in which they are painted. */
function pictures(
  commands: readonly Command[],
  from: Point = { x: 0, y: 0 },
  opacity = 1,
): readonly Picture[] | null {
  const found: Picture[] = []
  for (const command of commands) {
    if (command.kind !== 'group' || command.turn || (command.scale ?? 1) !== 1) return null
    const { shapes, still } = command
    const own = opacity * (command.opacity ?? 1)
    const at = { x: from.x + (command.x ?? 0), y: from.y + (command.y ?? 0) }
    if (still) {
      found.push({ ...still, x: at.x + still.x, y: at.y + still.y, shapes, opacity: own })
      continue
    }
    const inner = pictures(shapes, at, own)
    if (!inner) return null
    found.push(...inner)
  }
  return found
}

const same = (a: Picture, b: Picture) =>
  a.shapes === b.shapes && a.x === b.x && a.y === b.y && a.opacity === b.opacity
