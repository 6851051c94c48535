import { type Point, between, clamp, distance, distanceToSegment, shareAlong, lerp } from './points.ts'

/** What a knob can be set to, and by which number its weight is shown: 1, or 10 for a scale without decimals. */
export interface Scale {
  readonly least: number
  readonly most: number
  readonly unit: 1 | 10
}
export const unitScale: Scale = { least: 0, most: 1, unit: 1 }

/** A link as a slider: its free length from node to node, and where on it (shares) weight 0 and the greatest weight lie. */
export interface Track extends Scale {
  readonly from: Point
  readonly to: Point
  readonly zero: number
  readonly one: number
}

const trackShare = { start: 0.12, one: 0.82, latestZero: 0.46 }
/** Of a scale that goes below 0: weight 0 is in the middle, or so far from it. */
const signedShare = { zero: 0.47, earliest: 0.37, latest: 0.57 }
/** Touch targets keep this far apart where they can, in px. */
const targetGap = 44
/** A knob is grabbed within this distance of its middle, a link within that of its line, in px. */
const grabWithin = { knob: 24, link: 18 }
/** Of knobs whose distances from the finger differ by less (px), each may be meant. */
const alike = 6
/** Half of the knob that is seen. */
const smallestGrip = 11

/** The free part of the line between two nodes of radius `radius`. */
export function freeLine(source: Point, target: Point, radius: number, scale: Scale = unitScale): Track {
  const length = distance(source, target) || 1
  const edge = Math.min(0.49, (radius - 0.5) / length)
  return { from: between(source, target, edge), to: between(source, target, 1 - edge), ...ends(scale) }
}

const ends = (scale: Scale) => ({
  ...scale,
  zero: scale.least < 0 ? signedShare.zero : trackShare.start,
  one: trackShare.one,
})

/** How much of the track is a weight of 1, on the side of `sign`. */
const shareOfOne = ({ zero, one, least, most }: Track, sign: number): number =>
  sign < 0 ? (trackShare.start - zero) / least : (one - zero) / most

/** Where the knob stands for a weight; weights beyond the scale stand at the ends. */
export function knobPlace(track: Track, weight: number): Point {
  const within = clamp(weight, track.least, track.most)
  return between(track.from, track.to, track.zero + within * shareOfOne(track, within))
}

/** The weight of the point on the track that is nearest to `at`, in hundredths. */
export function weightAt(track: Track, at: Point): number {
  const share = shareAlong(track.from, track.to, at) - track.zero
  const weight = share / shareOfOne(track, track.least < 0 ? share : 1)
  return Math.round(clamp(weight, track.least, track.most) * 100) / 100 + 0
}

/**
 * Moves the zero ends of tracks along their links until resting knobs keep 44 px apart, or as far as they can. Links keep
 * the full track where there is room.
 */
export function stagger(tracks: readonly Track[]): readonly Track[] {
  const slope = (i: number) => Math.abs(tracks[i]!.to.y - tracks[i]!.from.y)
  const order = tracks.map((_, i) => i)
  const steepFirst = [...order].sort((a, b) => slope(b) - slope(a))
  // Which link is asked first decides where it settles; a few beginnings are tried.
  const beginnings = [steepFirst, [...steepFirst].reverse(), order, [...order].reverse()]
  const turns = tracks.length <= 16 ? tracks.length : 1
  const tries = beginnings.flatMap((one) =>
    Array.from({ length: turns }, (_, k) => settle(tracks, [...one.slice(k), ...one.slice(0, k)])),
  )
  const best = tries.reduce((a, b) => (b.crowding < a.crowding ? b : a))
  return tracks.map((track, i) => ({ ...track, zero: best.zeros[i]! }))
}

/** Link after link takes the place with the least crowding, again and again while that helps. */
function settle(tracks: readonly Track[], order: readonly number[]) {
  const zeros = tracks.map(({ zero }) => zero)
  const others = (i: number) => tracks.flatMap((track, j) => (j === i ? [] : [restAt(track, zeros[j]!)]))
  for (let round = 0; round < 8; round++) {
    const before = zeros.join()
    for (const i of order) zeros[i] = roomiest(tracks[i]!, others(i))
    if (zeros.join() === before) break
  }
  return {
    zeros,
    crowding: tracks.reduce((sum, track, i) => sum + crowdingAt(track, zeros[i]!, others(i)), 0),
  }
}

const restAt = ({ from, to }: Track, zero: number) => between(from, to, zero)

/** How far the others come too near, squared; the last term prefers long tracks, level ones first, where that makes no difference. */
function crowdingAt(track: Track, zero: number, others: readonly Point[]): number {
  const rest = restAt(track, zero)
  const tight = others.reduce((sum, other) => sum + Math.max(0, targetGap - distance(rest, other)) ** 2, 0)
  const level = Math.abs(track.to.x - track.from.x) / (distance(track.from, track.to) || 1)
  return tight + Math.abs(zero - ends(track).zero) * level ** 8
}

function roomiest(track: Track, others: readonly Point[]): number {
  let best = { zero: track.zero, crowding: Infinity }
  const [from, to] =
    track.least < 0 ? [signedShare.earliest, signedShare.latest] : [trackShare.start, trackShare.latestZero]
  for (let zero = from; zero <= to; zero += 0.02) {
    const crowding = crowdingAt(track, zero, others)
    if (crowding < best.crowding) best = { zero, crowding }
  }
  return best.zero
}

/** Drawn width of a link: 3 + 13·|w| px. */
export const linkWidth = (weight: number): number => 3 + 13 * Math.min(1, Math.abs(weight))

/**
 * Two knobs are told apart from this gap between their middles, and one moves this far along its link for it at most, in
 * px. In networks with more links knobs cover each other anyway.
 */
const apart = { gap: 2 * smallestGrip, farthest: 24, links: 36 }

/**
 * Knobs at the places of their weights; where one would cover another, both move along their links until they can be told
 * apart. Knob `still` is held by a pointer and does not move.
 */
export function knobPlaces(
  tracks: readonly Track[],
  weights: readonly number[],
  still: number | null = null,
): readonly Point[] {
  const places = tracks.map((track, i) => knobPlace(track, weights[i] ?? 0))
  if (places.length > apart.links) return places
  for (let i = 0; i < places.length; i++)
    for (let j = i + 1; j < places.length; j++) {
      if (distance(places[i]!, places[j]!) >= apart.gap) continue
      const both = [i, j].map((k) => moved(tracks[k]!, places[k]!, k === still))
      const found = nearestPair(both[0]!, both[1]!)
      if (found) [places[i], places[j]] = found
    }
  return places
}

/** The places that a knob can move to along its link, by the px of the way: none, one forth and one back, … */
function moved({ from, to }: Track, at: Point, stays: boolean): readonly (readonly Point[])[] {
  const [share, length] = [shareAlong(from, to, at), distance(from, to) || 1]
  const steps = Array.from({ length: apart.farthest + 1 }, (_, px) => px)
  return steps.map((px) =>
    (stays || px === 0 ? [0] : [px, -px]).map((by) => between(from, to, clamp(share + by / length, 0, 1))),
  )
}

/** The two places after the shortest way at which the knobs can be told apart; undefined: there is none. */
function nearestPair(
  one: readonly (readonly Point[])[],
  other: readonly (readonly Point[])[],
): readonly [Point, Point] | undefined {
  for (const [px, places] of one.entries())
    for (const a of places) for (const b of other[px]!) if (distance(a, b) >= apart.gap) return [a, b]
  return undefined
}

/** Radii within which knobs answer to a pointer: they touch at most, so that a press belongs to the nearest. */
export function gripsOf(knobs: readonly Point[]): readonly number[] {
  const radii = knobs.map(() => grabWithin.knob)
  for (let i = 0; i < knobs.length; i++)
    for (let j = i + 1; j < knobs.length; j++) {
      if (Math.abs(knobs[i]!.x - knobs[j]!.x) >= 2 * grabWithin.knob) continue
      const half = Math.max(smallestGrip, distance(knobs[i]!, knobs[j]!) / 2)
      radii[i] = Math.min(radii[i]!, half)
      radii[j] = Math.min(radii[j]!, half)
    }
  return radii
}

/**
 * Which links a finger at `at` may mean: the nearest knob within reach, with others that are as near; where there is none,
 * the nearest line within reach. Nearest first. Indices into `tracks`.
 */
export function linksAt(tracks: readonly Track[], weights: readonly number[], at: Point): readonly number[] {
  const within = (reach: number, gaps: readonly number[]) => {
    const most = Math.min(reach, Math.min(...gaps) + alike)
    return gaps.flatMap((gap, i) => (gap <= most ? [i] : [])).sort((a, b) => gaps[a]! - gaps[b]!)
  }
  const knobs = within(
    grabWithin.knob,
    knobPlaces(tracks, weights).map((place) => distance(place, at)),
  )
  if (knobs.length > 0) return knobs
  return within(
    grabWithin.link,
    tracks.map(({ from, to }) => distanceToSegment(from, to, at)),
  ).slice(0, 1)
}

/** Of several links under the finger the one whose direction is nearest to the finger's movement. */
export function alongMovement(tracks: readonly Track[], candidates: readonly number[], move: Point): number {
  const turn = ({ from, to }: Track) =>
    Math.abs((to.x - from.x) * move.y - (to.y - from.y) * move.x) / (distance(from, to) || 1)
  return candidates.reduce((best, one) => (turn(tracks[one]!) < turn(tracks[best]!) ? one : best))
}

/** How the signal on a link is shown: `count` pulses on its length at a time, each `milliseconds` under way. */
export interface PulseRate {
  readonly count: 0 | 1 | 2 | 4 | 8
  readonly milliseconds: number
}

/**
 * Pulses for a signal (input × weight): 900 ms at 50, 1600 towards 0, 500 at 100, at most 8 at a time. Counts double, so
 * that pulses already under way stay where they are. Signals come in steps of 5, so that a trembling value changes nothing.
 */
export function pulseRate(signal: number): PulseRate {
  const strength = Math.min(100, Math.abs(signal))
  if (strength < 0.5) return { count: 0, milliseconds: 1600 }
  const step = Math.max(5, Math.round(strength / 5) * 5)
  const milliseconds = step <= 50 ? lerp(1600, 900, step / 50) : lerp(900, 500, (step - 50) / 50)
  return { count: step < 15 ? 1 : step < 35 ? 2 : step < 65 ? 4 : 8, milliseconds }
}
