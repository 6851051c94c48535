import type { Chosen } from './chosen.ts'

/** What a hand points at, on the map or in the table: both show it. And what it has tapped. */
export class Marked {
  #road = $state.raw<readonly [number, number] | null>(null)
  chosen = $state.raw<Chosen | null>(null)

  get road() {
    return this.#road
  }

  point(road: readonly [number, number] | null): void {
    this.#road = road
  }

  is(from: number, to: number): boolean {
    return this.#road?.[0] === from && this.#road[1] === to
  }
}
