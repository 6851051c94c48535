/** What the slider shows: a stretch of time in ticks, so long that the present has room to move in it. */
export interface Span {
  readonly from: number
  readonly length: number
  /** Ticks at which a number stands. */
  readonly labels: readonly number[]
}

const second = 60
/** Lengths in seconds, each with the distance of its numbers. */
const lengths: readonly (readonly [length: number, every: number])[] = [
  [5, 1],
  [10, 2],
  [30, 5],
  [60, 10],
  [120, 20],
  [300, 60],
  [660, 120],
]

/** The stretch for a run whose moments are kept from `first` to `now` (ticks). */
export function spanOf(first: number, now: number): Span {
  const [length, every] = lengths.find(([seconds]) => (now - first) / second <= seconds) ?? lengths.at(-1)!
  const start = Math.ceil(first / second / every) * every
  const end = Math.floor((first / second + length) / every) * every
  const labels = []
  for (let at = start; at <= end; at += every) labels.push(at * second)
  return { from: first, length: length * second, labels }
}

/** Where a tick stands, 0..1. */
export const shareOf = ({ from, length }: Span, tick: number): number =>
  Math.min(1, Math.max(0, (tick - from) / length))

/** Room for the thumb at both ends of the slider, in px. */
const edge = 20

/** Where a tick stands on a slider of this width, in px. */
export const placeOn = (span: Span, tick: number, width: number): number =>
  edge + shareOf(span, tick) * (width - 2 * edge)

/** The tick that stands at a place of a slider of this width (px); it may lie beyond the run. */
export const tickAt = ({ from, length }: Span, place: number, width: number): number =>
  Math.round(from + ((place - edge) / (width - 2 * edge)) * length)

/** Where a key takes the slider; null for other keys. Arrows go a tenth of a second, with Shift one, pages ten. */
export function movedBy(
  { key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  tick: number,
  { first, now }: { readonly first: number; readonly now: number },
): number | null {
  const far = shiftKey ? second : second / 10
  const ways: { readonly [key: string]: number } = {
    ArrowLeft: tick - far,
    ArrowDown: tick - far,
    ArrowRight: tick + far,
    ArrowUp: tick + far,
    PageDown: tick - 10 * second,
    PageUp: tick + 10 * second,
    Home: first,
    End: now,
  }
  const to = ways[key]
  return to === undefined ? null : Math.min(now, Math.max(first, to))
}
