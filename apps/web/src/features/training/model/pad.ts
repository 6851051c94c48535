import type { Wheels } from '@botgarten/lab'

/** A pad held so near to its middle counts as the middle. */
const deadZone = 0.08
/** What a key moves the wheels by, in percent. */
const nudge = 10

const cut = (value: number) => Math.max(-100, Math.min(100, Math.round(value))) + 0

/** The wheels of a place on the pad: x to the right and y ahead, both −1..1. left = ahead + aside, right = ahead − aside. */
export function wheelsOfPad(x: number, y: number): Wheels {
  const [aside, ahead] = [x, y].map((part) => (Math.abs(part) < deadZone ? 0 : part)) as [number, number]
  return { left: cut(100 * (ahead + aside)), right: cut(100 * (ahead - aside)) }
}

/** Where on the pad these wheels are; cut to its rim. */
export function padOf({ left, right }: Wheels): { readonly x: number; readonly y: number } {
  const [x, y] = [(left - right) / 200, (left + right) / 200]
  const far = Math.max(1, Math.hypot(x, y))
  return { x: x / far, y: y / far }
}

/** The wheels after an arrow key on the pad; null for another key. */
export function nudged({ left, right }: Wheels, key: string): Wheels | null {
  const by = { ArrowUp: [1, 1], ArrowDown: [-1, -1], ArrowLeft: [-1, 1], ArrowRight: [1, -1] }[key]
  return by ? { left: cut(left + nudge * by[0]!), right: cut(right + nudge * by[1]!) } : null
}

/** Seconds that Bo's way is drawn ahead. */
const ahead = 2
const steps = 16

/** Where Bo would go with these wheels in 2 seconds, in cm from its middle. 100 percent is two wheel turns a second. */
export function wayAhead(
  pose: { readonly x: number; readonly y: number; readonly heading: number },
  wheels: Wheels,
  { wheelDiameter, trackWidth }: { readonly wheelDiameter: number; readonly trackWidth: number },
): readonly { readonly x: number; readonly y: number }[] {
  const speed = (percent: number) => (percent / 100) * 2 * Math.PI * wheelDiameter
  const [left, right] = [speed(wheels.left), speed(wheels.right)]
  const time = ahead / steps
  let heading = (pose.heading * Math.PI) / 180
  let { x, y } = pose
  const points = [{ x, y }]
  for (let step = 0; step < steps; step++) {
    const turn = ((right - left) / trackWidth) * time
    x += ((left + right) / 2) * time * Math.cos(heading + turn / 2)
    y += ((left + right) / 2) * time * Math.sin(heading + turn / 2)
    heading += turn
    points.push({ x, y })
  }
  return points
}
