import worlds from 'content:worlds'
import type { WorldFile } from '@botgarten/content'

/** Every world of the content, in the order of their folders. */
export const allWorlds = (): Promise<readonly { readonly id: string; readonly world: WorldFile }[]> =>
  Promise.all(worlds.worlds.map(async (id) => ({ id, world: (await worlds.world(id))! })))
