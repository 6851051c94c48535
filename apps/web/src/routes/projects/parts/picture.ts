import { floorAddress } from '#lib/content/cards.ts'
import type { Project } from '@botgarten/programs'

/** Address of the picture on the floor of a project's world, from the product or from the project itself. */
export function floorOf({ world, assets }: Project): string | null {
  const own = 'asset' in world.floor && Object.hasOwn(assets, world.floor.asset) && assets[world.floor.asset]
  return own ? `data:image/png;base64,${own.base64}` : floorAddress(world)
}
