import { percentOff, type CurvePoint } from '@botgarten/learning/neural-network/train'
import type { Size } from '#drawing/points.ts'

/** Where the curve lies in its box, in px. */
const margin = { left: 44, right: 14, top: 12, bottom: 26 }

export interface Plot {
  /** px of a round, and the round nearest to a px. */
  readonly x: (round: number) => number
  readonly roundAt: (px: number) => number
  readonly y: (loss: number) => number
  /** Numbers at the axes. */
  readonly rounds: readonly number[]
  readonly errors: readonly { readonly value: number; readonly y: number }[]
  readonly practised: string
  readonly kept: string
  readonly bottom: number
  readonly left: number
  readonly right: number
  readonly top: number
}

/** Not more points than a curve has px. */
const mostDrawn = 400

/** A loss as the axis counts it: percent off, or the loss itself. */
const measure = (loss: number, shares: boolean) => (shares ? loss : percentOff(loss))

/** @param least so many rounds the axis shows at least */
export function plotOf(
  curve: readonly CurvePoint[],
  { width, height }: Size,
  shares: boolean,
  least: number,
): Plot {
  const [left, right, top, bottom] = [margin.left, width - margin.right, margin.top, height - margin.bottom]
  const most = Math.max(least, curve.at(-1)?.round ?? 0)
  const all = curve.flatMap(({ practised, kept }) => (kept === null ? [practised] : [practised, kept]))
  const highest = niceTop(Math.max(shares ? 0.1 : 10, ...all.map((loss) => measure(loss, shares))))
  const x = (round: number) => left + ((right - left) * round) / most
  const y = (loss: number) => bottom - ((bottom - top) * Math.min(measure(loss, shares), highest)) / highest
  const every = Math.ceil(curve.length / mostDrawn)
  const drawn = curve.filter((_, at) => at % every === 0 || at === curve.length - 1)
  const path = (points: readonly (readonly [number, number])[]) =>
    points.map(([px, py], at) => `${at === 0 ? 'M' : 'L'}${px.toFixed(1)} ${py.toFixed(1)}`).join('')
  const steps = [0, 0.5, 1].map((share) => share * highest)
  return {
    ...{ x, y, left, right, top, bottom },
    roundAt: (px) => Math.max(0, Math.min(most, Math.round(((px - left) / (right - left)) * most))),
    rounds: [0, 1, 2, 3].map((third) => Math.round((most * third) / 3)),
    errors: steps.map((value) => ({ value, y: bottom - ((bottom - top) * value) / highest })),
    practised: path(drawn.map(({ round, practised }) => [x(round), y(practised)])),
    kept: path(drawn.flatMap(({ round, kept }) => (kept === null ? [] : [[x(round), y(kept)] as const]))),
  }
}

/** The next of 1, 2, 4, 6, 10, 20, … above a number. */
export function niceTop(value: number): number {
  for (let power = 0.1; ; power *= 10)
    for (const step of [1, 2, 4, 6]) if (step * power >= value) return Number((step * power).toFixed(6))
}
