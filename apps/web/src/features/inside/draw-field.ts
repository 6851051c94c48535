import { onFloor } from '#drawing/camera.ts'
import { clamp, type Size } from '#drawing/points.ts'
import { arrowOf, headOf } from './arrows.ts'
import type { Readings } from './field.svelte.ts'

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

/** Draws the field anew: arrows for a network that drives, else a disc in the colour of the strongest output, as large as it is. */
export function drawField(context: CanvasRenderingContext2D, drawn: Drawn): void {
  const { window, wheels } = drawn
  context.setTransform(1, 0, 0, 1, 0, 0)
  context.clearRect(0, 0, window.width, window.height)
  context.translate(-window.left, -window.top)
  if (wheels.left < 0 && wheels.right < 0) return drawDiscs(context, drawn)
  drawArrows(context, drawn)
}

/** All arrows are two paths: drawing each by itself would take a frame. */
function drawArrows(context: CanvasRenderingContext2D, drawn: Drawn): void {
  const { poses, spacing, answers, wheels, floor, scale } = drawn
  const width = clamp(spacing * scale * 0.075, 0.9, 2.4)
  const lines = new Path2D()
  const dots = new Path2D()
  poses.forEach((pose, index) => {
    const answer = answers[index]
    if (!answer) return
    const middle = onFloor(pose, floor, scale)
    if (!isSeen(drawn, middle)) return
    dots.moveTo(middle.x + width, middle.y)
    dots.arc(middle.x, middle.y, width, 0, 7)
    const points = arrowOf(pose, answer[wheels.left] ?? 0, answer[wheels.right] ?? 0, spacing)
    if (points.length > 0) addArrow(lines, points, spacing, (point) => onFloor(point, floor, scale))
  })
  context.lineWidth = width
  context.lineCap = context.lineJoin = 'round'
  context.strokeStyle = context.fillStyle = ARROW
  context.stroke(lines)
  context.fill(dots)
}

/** With one arrow of margin. */
function isSeen({ window, spacing, scale }: Drawn, { x, y }: Points[0]): boolean {
  const margin = spacing * scale
  const across = x > window.left - margin && x < window.left + window.width + margin
  return across && y > window.top - margin && y < window.top + window.height + margin
}

type Points = ReturnType<typeof arrowOf>

function addArrow(path: Path2D, points: Points, spacing: number, at: (point: Points[0]) => Points[0]): void {
  points.forEach((point, index) => {
    const { x, y } = at(point)
    if (index === 0) path.moveTo(x, y)
    else path.lineTo(x, y)
  })
  const tip = at(points.at(-1)!)
  const [one, other] = headOf(points, spacing * 0.2).map(at) as [Points[0], Points[0]]
  path.moveTo(one.x, one.y)
  path.lineTo(tip.x, tip.y)
  path.lineTo(other.x, other.y)
}

function drawDiscs(context: CanvasRenderingContext2D, drawn: Drawn): void {
  const { poses, spacing, answers, colours, floor, scale } = drawn
  context.strokeStyle = '#4A3428'
  context.lineWidth = 1.5
  poses.forEach((pose, index) => {
    const answer = answers[index]
    if (!answer) return
    const strongest = answer.indexOf(Math.max(...answer))
    const value = Math.max(0, Math.min(100, answer[strongest] ?? 0))
    const { x, y } = onFloor(pose, floor, scale)
    if (!isSeen(drawn, { x, y })) return
    context.beginPath()
    context.arc(x, y, Math.max(1.5, spacing * scale * 0.36 * Math.sqrt(value / 100)), 0, 7)
    context.fillStyle = value > 0 ? (colours[strongest]?.colour ?? ARROW) : '#4A3428'
    context.fill()
    if (value > 0) context.stroke()
  })
}
