import { cos, sin } from '@botgarten/numbers'
import { radiansOf } from '../angles.ts'
import { partOfShape } from '../geometry/parts.ts'
import type { Area, Floor, Line, World } from '../types.ts'
import { bytesOf, fillCircle, fillPolygon, type Point } from './fill.ts'
import { HIGHEST, WIDEST, type Picture } from './picture.ts'

const FINEST = 4

/**
 * The floor as sensors see it: the picture (stretched over the world, nearest pixels) or one colour, then areas, then
 * lines, each over what came before. Without a picture 1 to 4 pixels a cm, at most 1600 × 1200.
 */
export function paintFloor(
  world: Pick<World, 'size' | 'floor' | 'areas' | 'lines'>,
  picture?: Picture,
): Floor {
  const floor = picture ? laidOut(picture, world.size) : plain(world)
  for (const area of world.areas) paintArea(floor, area)
  for (const line of world.lines) paintLine(floor, line)
  return floor
}

function plain({ size, floor }: Pick<World, 'size' | 'floor'>): Floor {
  const fits = Math.min(FINEST, WIDEST / size.width, HIGHEST / size.height)
  const empty = blank(size, fits >= 1 ? Math.floor(fits) : fits)
  const { data } = empty
  data.set(bytesOf('colour' in floor ? floor.colour : '#FFFFFF'))
  // Twice as much each time: millions of pixels one by one take longer than a frame.
  for (let done = 3; done < data.length; done *= 2) data.copyWithin(done, 0, done)
  return empty
}

function laidOut(picture: Picture, size: World['size']): Floor {
  const pixelsPerCm = Math.min(picture.width / size.width, HIGHEST / size.height)
  const floor = blank(size, pixelsPerCm)
  if (floor.width === picture.width && floor.height === picture.height)
    return { ...floor, data: picture.data.slice() }
  for (let row = 0; row < floor.height; row++) {
    const fromRow = Math.floor(((row + 0.5) * picture.height) / floor.height) * picture.width
    for (let column = 0; column < floor.width; column++) {
      const from = (fromRow + Math.floor(((column + 0.5) * picture.width) / floor.width)) * 3
      floor.data.set(picture.data.subarray(from, from + 3), (row * floor.width + column) * 3)
    }
  }
  return floor
}

function blank(size: World['size'], pixelsPerCm: number): Floor {
  const width = Math.max(1, Math.round(size.width * pixelsPerCm))
  const height = Math.max(1, Math.round(size.height * pixelsPerCm))
  return { width, height, pixelsPerCm, data: new Uint8Array(width * height * 3) }
}

function paintArea(floor: Floor, { shape, pose, colour }: Area): void {
  const part = partOfShape(shape)
  if (part.kind === 'circle') return fillCircle(floor, [pose.x, pose.y], part.radius, colour)
  const c = cos(radiansOf(pose.heading))
  const s = sin(radiansOf(pose.heading))
  const corners = part.corners.map(([x, y]): Point => [pose.x + c * x - s * y, pose.y + s * x + c * y])
  fillPolygon(floor, corners, colour)
}

/** Everything within half the width of the way from point to point: round joints, round ends. */
function paintLine(floor: Floor, { points, width, colour }: Line): void {
  points.forEach(({ x, y }, index) => {
    fillCircle(floor, [x, y], width / 2, colour)
    const next = points[index + 1]
    if (next) fillPolygon(floor, stroke([x, y], [next.x, next.y], width), colour)
  })
}

function stroke([ax, ay]: Point, [bx, by]: Point, width: number): Point[] {
  const length = Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
  const x = length > 0 ? ((by - ay) / length) * (width / 2) : 0
  const y = length > 0 ? ((ax - bx) / length) * (width / 2) : 0
  return [[ax + x, ay + y], [bx + x, by + y], [bx - x, by - y], [ax - x, ay - y]] // prettier-ignore
}
