export const pages = ['map', 'inside', 'curves', 'trials'] as const
export type Page = (typeof pages)[number]

/** starter: words and stars · explorer: values too · expert: parameters as numbers, decay, rules, the formula. */
export const levels = ['starter', 'explorer', 'expert'] as const
export type Level = (typeof levels)[number]

/** What a hand has tapped: a station or a road of the map, or start and goal beside it. */
export type Chosen =
  | { readonly kind: 'station'; readonly station: number }
  | { readonly kind: 'road'; readonly a: number; readonly b: number }
  | { readonly kind: 'ends' }

/** Where a reward is paid, as blocks name it: a road pays in both directions. */
export function placesOf(chosen: Chosen): readonly string[] {
  if (chosen.kind === 'ends') return []
  if (chosen.kind === 'station') return [String(chosen.station)]
  return [`${chosen.a}-${chosen.b}`, `${chosen.b}-${chosen.a}`]
}

/** What a hand points at, on the map or in the table: both show it. And what it has tapped. */
export class Marked {
  #road = $state.raw<readonly [number, number] | null>(null)
  chosen = $state.raw<Chosen | null>(null)
  /** Own rewards were found on the map: they may be changed at every level, back from 0 as well. */
  pays = $state(false)

  get road() {
    return this.#road
  }

  /** The road to show on the map: what is pointed at, else what was tapped. */
  get shownRoad(): readonly [number, number] | null {
    const { chosen } = this
    return this.#road ?? (chosen?.kind === 'road' ? [chosen.a, chosen.b] : null)
  }

  point(road: readonly [number, number] | null): void {
    this.#road = road
  }

  is(from: number, to: number): boolean {
    const { chosen } = this
    if (
      chosen?.kind === 'road' &&
      `${chosen.a}-${chosen.b}` === [from, to].toSorted((a, b) => a - b).join('-')
    )
      return true
    return this.#road?.[0] === from && this.#road[1] === to
  }

  /** The station that was tapped: its row stands out in the table. */
  get station(): number | null {
    return this.chosen?.kind === 'station' ? this.chosen.station : null
  }
}
