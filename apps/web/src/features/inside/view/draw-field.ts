import type { Pose } from '@botgarten/simulation'
import { onFloor } from '#drawing/camera.ts'
import type { Command, Group } from '#drawing/commands.ts'
import { clamp, type Point, type Size } from '#drawing/points.ts'
import type { Readings } from '../model/field.svelte.ts'

/** Radians that the slower wheel's side turns by in an arrow, full speed against full speed. */
const TWIST = 1.9
const STEPS = 6
/** Below this speed in percent Bo stands. */
const STILL = 0.5

/**
 * The way a robot's nose would go, as a line in cm: from its middle on, so long that full speed goes from one arrow nearly to
 * the next. Empty where it stands.
 * @param left, right speed of the wheels in percent
 * @param spacing cm between two arrows
 */
export function arrowOf(pose: Pose, left: number, right: number, spacing: number): readonly Point[] {
  const [l, r] = [left, right].map((speed) => Math.max(-100, Math.min(100, speed)) / 100) as [number, number]
  if (Math.max(Math.abs(l), Math.abs(r)) * 100 < STILL) return []
  const ahead = ((l + r) / 2) * spacing * 0.55
  const turn = ((r - l) / 2) * TWIST
  const nose = spacing * 0.3 * (ahead < 0 ? -1 : 1)
  let heading = (pose.heading * Math.PI) / 180
  let { x, y } = pose
  const points: Point[] = [{ x, y }]
  for (let step = 0; step <= STEPS; step++) {
    if (step > 0) {
      const middle = heading + turn / STEPS / 2
      x += (Math.cos(middle) * ahead) / STEPS
      y += (Math.sin(middle) * ahead) / STEPS
      heading += turn / STEPS
    }
    points.push({ x: x + Math.cos(heading) * nose, y: y + Math.sin(heading) * nose })
  }
  return points
}

/** The two ends of an arrow's head at the end of its line, `size` long. */
export function headOf(points: readonly Point[], size: number): readonly [Point, Point] {
  const tip = points.at(-1)!
  const before = points.at(-2)!
  const angle = Math.atan2(tip.y - before.y, tip.x - before.x)
  const end = (by: number) => ({
    x: tip.x - size * Math.cos(angle + by),
    y: tip.y - size * Math.sin(angle + by),
  })
  return [end(0.55), end(-0.55)]
}

interface Drawn extends Readings {
  /** The network's outputs by pose; null where Bo has no room. */
  readonly answers: readonly (readonly number[] | null)[]
  /** Indices of the outputs that drive; −1: none does. */
  readonly wheels: { readonly left: number; readonly right: number }
  /** Of the outputs. */
  readonly colours: readonly { readonly colour: string }[]
  readonly floor: Size
  /** The part of the floor that is drawn, in px of its box. */
  readonly window: Size & { readonly left: number; readonly top: number }
  readonly scale: number
}

const ARROW = '#8A1F41'
const LINE = '#4A3428'

/** Arrows for a network that drives, else a disc in the colour of the strongest output, as large as it is. */
export function drawField(drawn: Drawn): Group {
  const { window, wheels } = drawn
  const { left: x, top: y, width, height } = window
  const drives = wheels.left >= 0 || wheels.right >= 0
  const shapes = drives ? drawArrows(drawn) : drawDiscs(drawn)
  return { kind: 'group', still: { x, y, width, height }, shapes }
}

/** All arrows are two commands: to paint each by itself would take a frame. */
function drawArrows(drawn: Drawn): readonly Command[] {
  const { poses, spacing, answers, wheels, floor, scale } = drawn
  const width = clamp(spacing * scale * 0.075, 0.9, 2.4)
  const [lines, dots] = [new Pen(), new Pen()]
  poses.forEach((pose, index) => {
    const answer = answers[index]
    if (!answer) return
    const middle = onFloor(pose, floor, scale)
    if (!isSeen(drawn, middle)) return
    dots.line([middle, middle])
    const points = arrowOf(pose, answer[wheels.left] ?? 0, answer[wheels.right] ?? 0, spacing)
    if (points.length > 0) addArrow(lines, points, spacing, (point) => onFloor(point, floor, scale))
  })
  return [
    { kind: 'lines', points: lines.points, stroke: ARROW, lineWidth: width },
    { kind: 'lines', points: dots.points, stroke: ARROW, lineWidth: 2 * width },
  ]
}

/** Writes lines one behind the other. */
class Pen {
  readonly #points: number[] = []

  line(points: readonly Point[]): void {
    if (this.#points.length > 0) this.#points.push(NaN, NaN)
    for (const { x, y } of points) this.#points.push(x, y)
  }

  get points(): Float32Array {
    return new Float32Array(this.#points)
  }
}

/** With one arrow of margin. */
function isSeen(
  { window, spacing, scale }: Pick<Drawn, 'window' | 'spacing' | 'scale'>,
  { x, y }: Point,
): boolean {
  const margin = spacing * scale
  const across = x > window.left - margin && x < window.left + window.width + margin
  return across && y > window.top - margin && y < window.top + window.height + margin
}

function addArrow(pen: Pen, points: readonly Point[], spacing: number, at: (point: Point) => Point): void {
  const [one, other] = headOf(points, spacing * 0.2)
  pen.line(points.map(at))
  pen.line([one, points.at(-1)!, other].map(at))
}

function drawDiscs({ poses, spacing, answers, colours, floor, scale, ...drawn }: Drawn): readonly Command[] {
  return poses.flatMap((pose, index) => {
    const answer = answers[index]
    const { x, y } = onFloor(pose, floor, scale)
    if (!answer || !isSeen({ spacing, scale, ...drawn }, { x, y })) return []
    const strongest = answer.indexOf(Math.max(...answer))
    const value = Math.max(0, Math.min(100, answer[strongest] ?? 0))
    const r = Math.max(1.5, spacing * scale * 0.36 * Math.sqrt(value / 100))
    const fill = value > 0 ? (colours[strongest]?.colour ?? ARROW) : LINE
    return [{ kind: 'circle', x, y, r, fill, ...(value > 0 ? { stroke: LINE, lineWidth: 1.5 } : {}) }]
  })
}
