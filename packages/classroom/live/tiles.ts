// What a teacher sees of each pupil, and who comes first. Plain data and arithmetic: the page uses the same.

/** What a pupil's page reports while it is visible: numbers to draw from, never a picture of the screen. */
export interface Here {
  readonly card: string | null
  readonly project: string | null
  /** One a check of the card, in its order. */
  readonly checks: readonly ('open' | 'passed' | 'failed')[]
  /** How many runs in a row have failed at the same check. */
  readonly failed: number
  readonly running: boolean
  /** Whole seconds since the child changed something. */
  readonly idle: number
  /** Size of the world, cm. */
  readonly size: readonly [number, number] | null
  readonly pose: { readonly x: number; readonly y: number; readonly heading: number } | null
  /** x and y by turns, cm, the oldest first. */
  readonly trail: readonly number[]
}

export interface Live extends Omit<Here, 'idle'> {
  /** When the pupil was heard of last, and when something was changed last; ms since 1970 by the server's clock. */
  readonly seenAt: number
  readonly changedAt: number
}

export interface Tile {
  readonly id: string
  readonly nickname: string
  readonly isNew: boolean
  readonly locked: boolean
  readonly handAt: number | null
  /** Null: not heard of since the class was opened. */
  readonly live: Live | null
}

/** Why a pupil needs somebody. `since`: ms since 1970. */
export type Need =
  | { readonly kind: 'hand'; readonly since: number }
  | { readonly kind: 'sameCheck'; readonly times: number }
  | { readonly kind: 'noChange'; readonly since: number }

const minute = 60_000
const noChangeFor = 3 * minute
const sameCheckTimes = 5
/** Three reports missed. */
const away = 20_000

export const isHere = ({ live }: Pick<Tile, 'live'>, now: number): boolean =>
  live !== null && now - live.seenAt < away

const allPassed = ({ checks }: Live) => checks.length > 0 && checks.every((check) => check === 'passed')

/** Hand up, the same check failed five times, or nothing changed for three minutes while the page is open. */
export function needOf(tile: Pick<Tile, 'handAt' | 'live'>, now: number): Need | null {
  const { handAt, live } = tile
  if (handAt !== null) return { kind: 'hand', since: handAt }
  if (live === null || !isHere(tile, now) || allPassed(live)) return null
  if (live.failed >= sameCheckTimes) return { kind: 'sameCheck', times: live.failed }
  if (now - live.changedAt >= noChangeFor) return { kind: 'noChange', since: live.changedAt }
  return null
}

const kinds = ['hand', 'sameCheck', 'noChange'] as const
const rankOf = (need: Need | null) => (need === null ? kinds.length : kinds.indexOf(need.kind))
const weightOf = (need: Need) => (need.kind === 'sameCheck' ? -need.times : need.since)

/** Who needs somebody comes first: hands before checks before silence, the longest first; the rest from A to Z. */
export function inOrder<One extends Tile>(tiles: readonly One[], now: number): One[] {
  const all = tiles.map((tile) => ({ tile, need: needOf(tile, now) }))
  return all
    .toSorted(
      (one, other) =>
        rankOf(one.need) - rankOf(other.need) ||
        (one.need && other.need ? weightOf(one.need) - weightOf(other.need) : 0) ||
        one.tile.nickname.localeCompare(other.tile.nickname),
    )
    .map(({ tile }) => tile)
}
