import { optimumOf } from '@botgarten/learning/q-learning'
import type { MapFile } from '@botgarten/maps'
import { offered, worldOf, type Cage } from '@botgarten/maps/zoo'

/** What a move is worth: what it pays at once, and 80 % of what comes then. */
export interface Worth {
  readonly to: number
  readonly pays: number
  readonly then: number
  readonly sum: number
  readonly isBest: boolean
}

/** Why Bo decides so at the station of a cage: the move that is meant, and the best of the others. Null where a cage names none. */
export function reasonAt(
  cage: Cage,
  map: MapFile,
  setting: number,
): { readonly at: number; readonly moves: readonly [meant: Worth, other: Worth] } | null {
  if (!cage.why) return null
  const { at, to } = cage.why
  const gamma = offered.aLot
  const world = worldOf(cage, map, setting, gamma)
  const { q, best } = optimumOf(world, gamma)
  const actions = [...q.keys()].filter((action) => world.from[action] === at)
  const worthOf = (action: number): Worth => {
    const [pays, sum] = [world.reward[action]!, q[action]!]
    return {
      to: world.meant[action]!,
      pays,
      then: (sum - pays) / gamma,
      sum,
      isBest: best[at]!.includes(action),
    }
  }
  const worths = actions.map(worthOf).toSorted((a, b) => b.sum - a.sum)
  return { at, moves: [worths.find((one) => one.to === to)!, worths.find((one) => one.to !== to)!] }
}
