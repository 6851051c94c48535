import { isSaid } from '#words/say.ts'
import type { WorldFile } from '@botgarten/materials'

const files = import.meta.glob<WorldFile>('../../../../content/worlds/*/world.json', { import: 'default' })

/** Every world of the content that has a name (`worldName.<folder>`), in the order of their folders. */
export async function allWorlds(): Promise<readonly { readonly id: string; readonly world: WorldFile }[]> {
  const named = Object.entries(files).flatMap(([path, load]) => {
    const id = /([^/]+)\/world\.json$/.exec(path)![1]!
    return isSaid(`worldName.${id}`) ? [{ id, load }] : []
  })
  return Promise.all(named.map(async ({ id, load }) => ({ id, world: await load() })))
}
