import { isHere, needOf, type Live, type Need, type Tile } from '@botgarten/classroom/tiles'

export type { Live, Need, Tile }

/** A tile of the live view with what the page works out of it. */
export interface SeenTile {
  readonly tile: Tile
  readonly need: Need | null
  readonly here: boolean
  /** All checks of the card hold. */
  readonly done: boolean
}

const isDone = (live: Live | null): boolean =>
  live !== null && live.checks.length > 0 && live.checks.every((check) => check === 'passed')

/** @param now by the server's clock */
export const seenTile = (tile: Tile, now: number): SeenTile => ({
  ...{ tile, need: needOf(tile, now), here: isHere(tile, now), done: isDone(tile.live) },
})

/** Where a robot has been: x and y by turns become points. */
export const trailOf = ({ trail }: Live): readonly { readonly x: number; readonly y: number }[] =>
  Array.from({ length: Math.floor(trail.length / 2) }, (_, at) => ({
    x: trail[at * 2]!,
    y: trail[at * 2 + 1]!,
  }))

/** Whole minutes since a moment. */
export const minutesSince = (then: number, now: number): number =>
  Math.max(0, Math.floor((now - then) / 60_000))

/** How long ago something was, as the messages `teacher.ago.<unit>` word it. */
export function agoOf(
  then: number,
  now: number,
): { readonly unit: 'seconds' | 'minutes'; readonly count: number } {
  const seconds = Math.max(0, Math.floor((now - then) / 1000))
  return seconds < 60
    ? { unit: 'seconds', count: seconds }
    : { unit: 'minutes', count: minutesSince(then, now) }
}
