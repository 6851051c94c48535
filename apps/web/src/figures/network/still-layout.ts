import { labelOffsets, labelSides } from '#drawing/labels.ts'
import type { NetworkLayout } from '#drawing/network.ts'
import type { Point, Size } from '#drawing/points.ts'
import { freeLine, knobPlace, stagger, type Scale, type Track, unitScale } from '#drawing/track.ts'
import { settleDeep } from '#figures/network/deep/layout.ts'
import type { Weights } from '@botgarten/learning/neural-network'
import type { NetworkOutline } from '@botgarten/programs'
import { hiddenColumn } from '#figures/network/deep/columns.ts'

/** A net as it is drawn: how many neurons each layer shows, and the weights link by link as the stage draws them. */
export interface DrawnNet {
  readonly counts: readonly number[]
  /** Neurons of each layer that are left out: in their place, before its last one, a row is free. */
  readonly left: readonly number[]
  readonly weights: readonly number[]
  readonly scale: Scale
}

export const settleOf = ({ counts }: DrawnNet) => (counts.length > 2 ? settleDeep : stagger)

const radius = 24
/** Names stand beside the first and the last layer. */
const side = 124
/** Between two layers' nodes, and between those of three and more: less where no weight is written. */
const apart = { two: 212, more: 256, plain: 150 }
/** Between the rows of the first layer, at least. */
const lowestRow = { other: 88, plain: 56 }
/** Over the first row and below the last there is room for a weight. */
const edge = { written: 58, empty: 44 }
const growth = [1, 1.15, 1.3, 1.45, 1.6, 1.8, 2]
/** How far apart rows are beside those of the first layer, where knobs of equal weights meet in the middle otherwise. */
const spreads = [1.25, 1.55, 2.5]

/** A net that stands still, with names beside it: as low as it can be without a knob or a weight on anything else. */
export function drawnLayout(net: DrawnNet): NetworkLayout {
  const lowest = isPlain(net) ? lowestRow.plain : lowestRow.other
  const withSpread = (spread: number) => growth.map((by) => layoutWith(net, lowest * by, spread))
  const spread = spreads.flatMap(withSpread).sort((a, b) => a.stage.height - b.stage.height)
  const layouts = [...withSpread(1), ...spread]
  let best = { layout: layouts[0]!, covered: Infinity }
  for (const layout of layouts) {
    const covered = coveredIn(net, layout) + knobsIn(net, layout)
    if (covered < best.covered) best = { layout, covered }
    if (covered === 0) break
  }
  return best.layout
}

const isWritten = (weights: readonly number[]) => weights.some((weight) => weight !== 0)
/** Knobs of hidden layers that all are at 0 need little room. */
export const isPlain = ({ counts, weights }: DrawnNet) => counts.length > 2 && !isWritten(weights)

function layoutWith(net: DrawnNet, row: number, spread: number): NetworkLayout {
  const { counts, left, weights } = net
  const gap = isPlain(net) ? apart.plain : counts.length > 2 ? apart.more : apart.two
  const rows = counts.map((_, k) => (k === 0 ? row : row * spread))
  const top = isWritten(weights) ? edge.written : edge.empty
  const places = counts.map((count, k) => (left[k] === 0 ? count : count + 1))
  const height = 2 * top + Math.max(...places.map((count, k) => (count - 1) * rows[k]!))
  return {
    radius,
    columns: places.map((count, k) =>
      Array.from({ length: count }, (_, at) => ({
        x: side + k * gap,
        y: height / 2 + (at - (count - 1) / 2) * rows[k]!,
      })).filter((_, at) => left[k] === 0 || at !== count - 2),
    ),
    stage: { width: 2 * side + (counts.length - 1) * gap, height },
    labels: 'beside',
    labelWidth: side - radius - 14,
    places: true,
  }
}

/** Its links, as the stage draws them. */
function tracksOf(net: DrawnNet, layout: NetworkLayout): readonly Track[] {
  const lines = layout.columns
    .slice(1)
    .flatMap((ends, l) =>
      layout.columns[l]!.flatMap((start) => ends.map((end) => freeLine(start, end, radius, net.scale))),
    )
  return settleOf(net)(lines)
}

/** How large things are, in px. */
const sizes = { weight: { width: 46, height: 28 }, knob: { width: 30, height: 30 } }
const node: Size = { width: 2 * radius, height: 2 * radius }

/** How much of each other weights, knobs and nodes cover, in px². */
export function coveredIn(net: DrawnNet, layout: NetworkLayout): number {
  const knobs = tracksOf(net, layout).map((track, i) => knobPlace(track, net.weights[i]!))
  const sides = labelSides(knobs, net.weights, layout.stage)
  const written = knobs.flatMap(({ x, y }, i) => {
    const off = labelOffsets[sides[i]!]
    return net.weights[i] === 0 ? [] : [{ x: x + off.x, y: y + off.y }]
  })
  const things = [
    ...knobs.map((at) => ({ at, size: sizes.knob })),
    ...layout.columns.flat().map((at) => ({ at, size: node })),
  ]
  const sum = (all: readonly number[]) => all.reduce((a, b) => a + b, 0)
  return sum(
    written.map((at, i) => {
      const others = written.slice(i + 1).map((other) => ({ at: other, size: sizes.weight }))
      return sum([...things, ...others].map((thing) => shared(at, sizes.weight, thing.at, thing.size)))
    }),
  )
}

/** From the middle of a knob to the outer end of its outline, in px: one at 0 is smaller. */
const reach = (weight: number) => (weight === 0 ? 13 : 16)

/** How much knobs cover each other, in px. */
export function knobsIn(net: DrawnNet, layout: NetworkLayout): number {
  const knobs = tracksOf(net, layout).map((track, i) => knobPlace(track, net.weights[i]!))
  return knobs
    .flatMap((a, i) =>
      knobs.slice(i + 1).map((b, j) => {
        const touching = reach(net.weights[i]!) + reach(net.weights[i + 1 + j]!)
        return Math.max(0, touching - Math.hypot(a.x - b.x, a.y - b.y))
      }),
    )
    .reduce((sum, one) => sum + one, 0)
}

const shared = (a: Point, aSize: Size, b: Point, bSize: Size): number =>
  Math.max(0, (aSize.width + bSize.width) / 2 - Math.abs(a.x - b.x)) *
  Math.max(0, (aSize.height + bSize.height) / 2 - Math.abs(a.y - b.y))

interface Named {
  readonly id: string
}

/** A layer of more neurons than this is summed up: its first ones, and its last. */
const most = 6
const first = 2

/** The neurons of a layer that are drawn where a net stands still. */
export const drawnOf = <One>(layer: readonly One[]): readonly One[] =>
  layer.length > most ? [...layer.slice(0, first), layer.at(-1)!] : layer

/** Knobs go from 0 to 1, and as far beyond as the weights do. */
function scaleFor(all: readonly number[]): Scale {
  const far = Math.max(1, ...all.map((weight) => Math.ceil(Math.abs(weight))))
  return { ...unitScale, least: all.some((weight) => weight < 0) ? -far : 0, most: far }
}

/** What of a network its drawing depends on. */
export function drawnNet({ inputs, hidden, outputs }: NetworkOutline, weights: Weights): DrawnNet {
  const whole: readonly (readonly Named[])[] = [inputs, ...hidden.map(hiddenColumn), outputs]
  const layers = whole.map(drawnOf)
  const links = layers
    .slice(1)
    .flatMap((ends, l) => layers[l]!.flatMap((from) => ends.map((to) => weights[from.id]?.[to.id] ?? 0)))
  const counts = layers.map(({ length }) => length)
  const left = whole.map(({ length }, k) => length - counts[k]!)
  return { counts, left, weights: links, scale: scaleFor(links) }
}
