import { readMap } from '@botgarten/maps'
import { roadsOf } from '../roads.ts'
import type { Stage } from '../stage.ts'

/** A map as features get it, without its picture: only a browser can draw that. @param text the map's SVG */
export function stageOf(id: string, text: string): Stage {
  const map = readMap(text).map!
  return { id, map, roads: roadsOf(map), picture: undefined as never }
}
