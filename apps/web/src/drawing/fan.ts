import { actionFill, actionSign, type Wheels } from './action-signs.ts'
import type { Command, Group } from './commands.ts'
import { clamp, turned, type Point, type Size } from './points.ts'

// What a robot would do in each case, as fields before it: no map, but how near to each eye something is.

/** Fields by bucket of the left sensor, then of the right one: which action is best; null: not known yet. */
export interface Fan {
  readonly fields: readonly (readonly (number | null)[])[]
  /** Where it stands: bucket left, bucket right; null: nowhere in the fan. */
  readonly now: readonly [left: number, right: number] | null
  readonly actions: readonly Wheels[]
}

const line = '#4A3428'
const active = '#1F67B3'
/** Of the fields of a fan of 3 × 3, in cm. More fields are smaller, down to what can be read. */
const fieldCm = 17
const leastPx = 22
/** From the middle of the robot to the first field, in cm. */
const before = 12

/** Px. @param room from the robot to where nothing is seen any more, in px */
export function fieldSide({ fields }: Fan, scale: number, room = Infinity): number {
  const most = Math.max(3, fields.length, ...fields.map(({ length }) => length))
  const inSight = (room - before * scale) / (most * Math.SQRT2)
  return Math.max(leastPx, Math.min(inSight, (fieldCm * scale * 3) / most))
}

const hasTwo = ({ fields }: Fan) => (fields[0]?.length ?? 0) > 1
const middleOf = (fan: Fan) => (hasTwo(fan) ? onDiagonals : straight)

/** Its fields as one picture, in px about the middle of the robot, which looks up. */
export function drawFan(fan: Fan, scale: number, room = Infinity): Group {
  const side = fieldSide(fan, scale, room)
  const middle = middleOf(fan)
  const shapes = fan.fields.flatMap((row, left) =>
    row.map((action, right) =>
      field(middle(left, right, side, before * scale), side, action, fan.actions, hasTwo(fan)),
    ),
  )
  return { kind: 'group', still: boxOf(fan, side, before * scale), turns: true, shapes }
}

/** The frame of the field in which the robot stands. */
export function drawFanNow(fan: Fan, scale: number, room = Infinity): readonly Command[] {
  if (!fan.now) return []
  const side = fieldSide(fan, scale, room)
  const at = middleOf(fan)(...fan.now, side, before * scale)
  return [square(at, side, hasTwo(fan), { stroke: active, lineWidth: 5 })]
}

/** Corners of all fields, in px about the middle of the robot, which looks up. */
function cornersOf(fan: Fan, scale: number, room: number): readonly Point[] {
  const side = fieldSide(fan, scale, room)
  const half = side / (hasTwo(fan) ? Math.SQRT2 : 2)
  const around = hasTwo(fan) ? onPoint : flat
  return fan.fields.flatMap((row, left) =>
    row.flatMap((_, right) => {
      const { x, y } = middleOf(fan)(left, right, side, before * scale)
      return around.map(([across, up]) => ({ x: x + across * half, y: y + up * half }))
    }),
  )
}

const flat = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
] as const
const onPoint = [
  [0, -1],
  [1, 0],
  [0, 1],
  [-1, 0],
] as const

/** Px to the edge of what is seen: the lines of the fields. */
const edge = 4

/**
 * Where a fan has to be drawn so that none of its fields is out of sight: about its robot at `at`, or as little beside that as
 * will do. A robot that is itself out of sight takes it along.
 * @param turn of the robot, degrees clockwise from up
 * @param seen what is seen, in the px of `at`
 */
export function fanInSight(
  fan: Fan,
  scale: number,
  { at, turn, seen }: { readonly at: Point; readonly turn: number; readonly seen: Size & Point },
): Point {
  const corners = cornersOf(fan, scale, roomIn(seen)).map((corner) => turned(corner, turn))
  const [right, bottom] = [seen.x + seen.width, seen.y + seen.height]
  if (at.x < seen.x || at.y < seen.y || at.x > right || at.y > bottom) return at
  const within = (place: number, ends: readonly number[], from: number, to: number) =>
    clamp(place, from + edge - Math.min(...ends), to - edge - Math.max(...ends))
  return {
    x: within(
      at.x,
      corners.map(({ x }) => x),
      seen.x,
      right,
    ),
    y: within(
      at.y,
      corners.map(({ y }) => y),
      seen.y,
      bottom,
    ),
  }
}

/** From the middle of what is seen to its nearest edge: a fan is no longer, where it can be read so. */
export const roomIn = ({ width, height }: Size): number => Math.min(width, height) / 2

/** What the fields cover, with their lines. */
function boxOf({ fields }: Fan, side: number, off: number): Size & Point {
  const most = fields.length + Math.max(0, ...fields.map(({ length }) => length))
  const [half, high] = [(most * side) / Math.SQRT2 + 2, off + (most * side) / Math.SQRT2 + 2]
  return { x: -half, y: -high, width: 2 * half, height: high }
}

/** The left eye's buckets go to the left and ahead, the right eye's to the right and ahead. */
const onDiagonals = (left: number, right: number, side: number, off: number): Point => ({
  x: ((right - left) * side) / Math.SQRT2,
  y: -off - ((left + right + 1) * side) / Math.SQRT2,
})
const straight = (left: number, _right: number, side: number, off: number): Point => ({
  x: 0,
  y: -off - (left + 0.5) * side,
})

function field(
  at: Point,
  side: number,
  action: number | null,
  actions: readonly Wheels[],
  turns: boolean,
): Command {
  const wheels = action === null ? undefined : actions[action]
  const fill = action === null ? '#FFFDF8' : actionFill(action)
  return {
    kind: 'group',
    shapes: [
      square(at, side, turns, { fill, stroke: line, lineWidth: 1.5, opacity: 0.92 }),
      {
        ...{ kind: 'group', ...at, scale: side / 34 },
        shapes: wheels ? [{ kind: 'path', d: actionSign(wheels), stroke: line, lineWidth: 2.4 }] : question,
      },
    ],
  }
}

const question: readonly Command[] = [
  {
    kind: 'path',
    d: 'M-4-4a4 4 0 1 1 6.3 3.2c-1.6 1-2.3 1.7-2.3 3.3M0 7v.1',
    stroke: '#6B5545',
    lineWidth: 2.4,
  },
]

type Look = Partial<Extract<Command, { kind: 'rect' }>>

function square({ x, y }: Point, side: number, turns: boolean, look: Look): Command {
  const half = side / 2
  const shape: Command = { kind: 'rect', x: -half, y: -half, width: side, height: side, ...look }
  return { kind: 'group', x, y, turn: turns ? 45 : 0, shapes: [shape] }
}
