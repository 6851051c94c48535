import type { QWorld } from '@botgarten/learning/q-learning'

/** The moves of a station by where they lead. */
export function movesFrom({ first, meant }: QWorld, station: number): ReadonlyMap<number, number> {
  const moves = new Map<number, number>()
  for (let move = first[station]!; move < first[station + 1]!; move++) moves.set(meant[move]!, move)
  return moves
}
