import zoo from 'content:zoo'
import { readMap } from '@botgarten/maps'
import { takeApart } from '#figures/map/picture.ts'
import { roadsOf } from '#figures/map/roads.ts'
import { CageWork } from './cage-work.svelte.ts'

/** A cage with its map, ready to be looked at; null where there is no such cage. */
export async function openCage(id: string): Promise<CageWork | null> {
  const found = zoo.cages.find(({ cage }) => cage.id === id)
  if (!found) return null
  const drawing = await zoo.map(id)
  const { map } = readMap(drawing)
  return map && new CageWork(found, { id, map, picture: takeApart(drawing, map), roads: roadsOf(map) })
}
