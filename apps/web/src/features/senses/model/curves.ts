import type { Minute } from '@botgarten/learning/q-senses'

/** Size of the picture in its own units. */
export const paper = { width: 480, height: 150 } as const
const margin = { left: 46, right: 8, top: 10, bottom: 24 }
/** So many minutes have their bumps as numbers; of more every few are named below. */
const mostNamed = 12

interface Bar {
  readonly minute: number
  readonly bumps: number
  readonly x: number
  readonly y: number
  readonly width: number
  readonly height: number
}

export interface Curves {
  readonly pay: string
  readonly dots: readonly { readonly minute: number; readonly x: number; readonly y: number }[]
  readonly bars: readonly Bar[]
  /** Are bumps written beside their bars? */
  readonly named: boolean
  /** Numbers below, and beside. */
  readonly minutes: readonly { readonly minute: number; readonly x: number }[]
  readonly pays: readonly { readonly value: number; readonly y: number }[]
  readonly left: number
  readonly right: number
  readonly bottom: number
  /** Where pay is 0. */
  readonly zero: number
}

/** The next of 1, 2, 5, 10, … that is no less. */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1)))
  return [1, 2, 5, 10].map((step) => step * power).find((step) => step >= value)!
}

/**
 * Pay as a line over whole minutes, bumps as bars at the bottom that take at most half of the height.
 * @param most minutes that there will be
 */
export function curvesOf(curve: readonly Minute[], most: number): Curves {
  const count = Math.max(1, Math.ceil(most), curve.length)
  const [left, right, top, bottom] = [
    ...[margin.left, paper.width - margin.right, margin.top],
    paper.height - margin.bottom,
  ] as [number, number, number, number]
  const pays = curve.map(({ pay }) => pay)
  const step = roundUp((Math.max(10, ...pays) - Math.min(0, ...pays)) / 3)
  const [low, high] = [
    step * Math.floor(Math.min(0, ...pays) / step),
    step * Math.ceil(Math.max(10, ...pays) / step),
  ]
  const each = (right - left) / count
  const x = (minute: number) => left + each * (minute - 0.5)
  const y = (pay: number) => bottom - ((bottom - top) * (pay - low)) / (high - low)
  const mostBumps = Math.max(1, ...curve.map(({ bumps }) => bumps))
  const width = Math.min(24, each * 0.6)
  const dots = curve.map(({ pay }, at) => ({ minute: at + 1, x: x(at + 1), y: y(pay) }))
  const every = Math.ceil(count / mostNamed)
  return {
    ...{ left, right, bottom, dots, zero: y(0), named: count <= mostNamed },
    pay: dots.map((dot, at) => `${at === 0 ? 'M' : 'L'}${dot.x.toFixed(1)} ${dot.y.toFixed(1)}`).join(''),
    bars: curve.map(({ bumps }, at) => {
      const height = (bumps / mostBumps) * ((bottom - top) / 2)
      return { minute: at + 1, bumps, x: x(at + 1) - width / 2, y: bottom - height, width, height }
    }),
    minutes: Array.from({ length: count }, (_, at) => at + 1)
      .filter((minute) => minute === 1 || minute % every === 0)
      .map((minute) => ({ minute, x: x(minute) })),
    pays: Array.from({ length: Math.round((high - low) / step) + 1 }, (_, at) => {
      const value = low + at * step
      return { value, y: y(value) }
    }),
  }
}
