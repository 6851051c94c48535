import { percentOff, type CurvePoint } from '@botgarten/learning/neural-network/train'
import type { Point, Size } from '#drawing/points.ts'
import type { Compared } from '../model/comparing.svelte.ts'
import { niceTop } from './curve.ts'

const margin = { left: 44, right: 16, top: 12, bottom: 24 }

/** Where the lines of a comparison lie in their box, in px. */
export interface Comparison {
  readonly left: number
  readonly right: number
  readonly top: number
  readonly bottom: number
  readonly marks: readonly { readonly value: number; readonly y: number }[]
  readonly places: readonly { readonly value: number; readonly x: number }[]
  readonly practised: readonly string[]
  readonly kept: readonly string[]
  /** Of a line over numbers of examples: what was practised with each. */
  readonly dots: readonly Point[]
}

const pathOf = (points: readonly Point[]) =>
  points.map(({ x, y }, at) => `${at === 0 ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`).join('')

/** By seed each practice is a line over rounds; by size all ends together are one over numbers of examples. */
export function comparisonOf(
  { study, lines }: Compared,
  { width, height }: Size,
  shares: boolean,
): Comparison {
  const [left, right, top, bottom] = [margin.left, width - margin.right, margin.top, height - margin.bottom]
  const measure = (loss: number) => (shares ? loss : percentOff(loss))
  const groups = study === 'seeds' ? lines.map(({ curve }) => curve.map(byRound)) : [lines.map(byNumber)]
  const all = groups.flat()
  const losses = all.flatMap(({ practised, kept }) => (kept === null ? [practised] : [practised, kept]))
  const highest = niceTop(Math.max(shares ? 0.1 : 10, ...losses.map(measure).filter(Number.isFinite)))
  const most = Math.max(1, ...all.map(({ at }) => at))
  const x = (at: number) => left + ((right - left) * at) / most
  const y = (loss: number) => bottom - ((bottom - top) * Math.min(measure(loss), highest)) / highest
  const practised = groups.map((group) => group.map((one) => ({ x: x(one.at), y: y(one.practised) })))
  const kept = groups.map((group) =>
    group.flatMap((one) => (one.kept === null ? [] : [{ x: x(one.at), y: y(one.kept) }])),
  )
  const steps = [0, 0.5, 1].map((share) => share * highest)
  return {
    ...{ left, right, top, bottom },
    marks: steps.map((value) => ({ value, y: bottom - ((bottom - top) * value) / highest })),
    places: placesOf(study, all, most).map((value) => ({ value, x: x(value) })),
    practised: practised.map(pathOf),
    kept: kept.filter((points) => points.length > 0).map(pathOf),
    dots: study === 'sizes' ? practised.flat() : [],
  }
}

interface Place {
  readonly at: number
  readonly practised: number
  readonly kept: number | null
}

const byRound = ({ round, practised, kept }: CurvePoint): Place => ({ at: round, practised, kept })

function byNumber({ number, curve }: Compared['lines'][number]): Place {
  const { practised, kept } = curve.at(-1)!
  return { at: number, practised, kept }
}

/** Numbers at the axis: thirds of the rounds, or the numbers of examples. */
const placesOf = (study: Compared['study'], all: readonly Place[], most: number): readonly number[] =>
  study === 'sizes' ? all.map(({ at }) => at) : [0, 1, 2, 3].map((third) => Math.round((most * third) / 3))
