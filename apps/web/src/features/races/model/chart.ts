import type { Band, Criterion, LaneResult, Series } from '@botgarten/experiments/race'

/** The chart of the measure that decides the race. */
export const seriesOf: { readonly [criterion in Criterion]: Series } = {
  ...{ way: 'pace', stars: 'stars', falls: 'falls' },
}

/** A lane with values this many times those of the next one is cut off: it would flatten all other curves. */
const TOO_MUCH = 4

export interface Scale {
  readonly low: number
  readonly high: number
  /** Lanes whose curves are cut off at the edge. */
  readonly outside: readonly number[]
}

const extent = (bands: readonly Band[]) =>
  bands.reduce((most, { low, high }) => Math.max(most, Math.abs(low), Math.abs(high)), 0)

/** The range of the axis, from 0, without the lanes that are cut off. */
export function scaleOf(results: readonly LaneResult[], series: Series): Scale {
  const needs = results
    .map(({ curves }, lane) => ({ lane, need: extent(curves[series]) }))
    .toSorted((a, b) => b.need - a.need)
  while (needs.length > 1 && needs[0]!.need > TOO_MUCH * Math.max(needs[1]!.need, 1)) needs.shift()
  const inside = new Set(needs.map(({ lane }) => lane))
  const bands = results.flatMap(({ curves }, lane) => (inside.has(lane) ? curves[series] : []))
  return {
    low: Math.min(0, ...bands.map(({ low }) => low)),
    high: Math.max(0, ...bands.map(({ high }) => high)) || 1,
    outside: results.flatMap((_, lane) => (inside.has(lane) ? [] : [lane])),
  }
}

/** Two to five round numbers between two ends, with 0 if it is between them. */
export function ticksOf(low: number, high: number): readonly number[] {
  const rough = (high - low) / 3
  const power = 10 ** Math.floor(Math.log10(rough))
  const step = [1, 2, 5, 10].find((factor) => factor * power >= rough)! * power
  const first = Math.ceil(low / step)
  const count = Math.floor(high / step) - first + 1
  return Array.from({ length: count }, (_, index) => (first + index) * step)
}

export interface Paper {
  readonly x: (at: number) => number
  readonly y: (value: number) => number
}

const point = ({ x, y }: Paper, at: number, value: number) => `${x(at).toFixed(1)} ${y(value).toFixed(1)}`

/** The medians as path data, up to a point. */
export const lineOf = (bands: readonly Band[], paper: Paper): string =>
  bands.map(({ middle }, at) => `${at === 0 ? 'M' : 'L'}${point(paper, at, middle)}`).join('')

/** The middle half of all runs as an area. */
export const areaOf = (bands: readonly Band[], paper: Paper): string =>
  `M${[
    ...bands.map(({ high }, at) => point(paper, at, high)),
    ...bands.map(({ low }, at) => point(paper, at, low)).toReversed(),
  ].join('L')}z`

/** Heights of labels, moved apart until none covers another. Both in px, in the order of the lanes. */
export function apart(wanted: readonly number[], gap: number): readonly number[] {
  const order = wanted.map((y, lane) => ({ y, lane })).toSorted((a, b) => a.y - b.y)
  for (let at = 1; at < order.length; at++) order[at]!.y = Math.max(order[at]!.y, order[at - 1]!.y + gap)
  const found = [...wanted]
  for (const { y, lane } of order) found[lane] = y
  return found
}

const distinct = (places: readonly number[]) => [...new Set(places)]

/** Points of a line that have the mark of its lane, beside its end; a short race has one. */
export const marksAt = (last: number): readonly number[] =>
  distinct([0.3, 0.65].map((share) => Math.round(share * last)))

/** Points that are named below the curves: the first, the last, and where quarters of all tries are done. */
export function timesOf(points: readonly number[]): readonly number[] {
  const all = points.at(-1) ?? 0
  return distinct([0, 0.25, 0.5, 0.75, 1].map((share) => points.findIndex((tries) => tries >= share * all)))
}

/**
 * The times whose labels fit next to each other; the first and the last always stay. `x`: middle of a label in px; `width`: its
 * width in px.
 */
export function labelsThatFit(
  times: readonly number[],
  x: (point: number) => number,
  width: (point: number) => number,
): readonly number[] {
  const gap = 6
  const fit = (one: number, other: number) =>
    Math.abs(x(one) - x(other)) >= (width(one) + width(other)) / 2 + gap
  const last = times.at(-1)!
  const shown: number[] = []
  for (const time of times.slice(0, -1)) {
    const before = shown.at(-1)
    if (before === undefined || (fit(before, time) && fit(time, last))) shown.push(time)
  }
  return [...shown, last]
}
