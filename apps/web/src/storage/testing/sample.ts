import { parseProject, type Project } from '@botgarten/programs'
import { readFileSync } from 'node:fs'

/** For Vite a URL relative to `import.meta.url` is a file of the page. */
const here = import.meta.url

const read = (path: string) =>
  JSON.parse(readFileSync(new URL(`../../../../../content/${path}`, here), 'utf8')) as object

/** A card with its start program. */
const card = (id: string, folder: string): Project =>
  parseProject({
    ...{ botgarten: 1, name: id, card: id, assets: {} },
    ...read(`cards/network/${folder}/start.json`),
    world: read(`worlds/${id}/world.json`),
  })
export const friendship = card('friendship', '05-friendship')
export const fear = card('fear', '06-fear')

export const hash = 'a'.repeat(64)

/** On a floor of its own, of so many letters. */
export const withPicture = (letters: number, project = friendship, of = hash): Project => ({
  ...project,
  world: { ...project.world, floor: { asset: of } },
  assets: { [of]: { type: 'image/png', base64: 'A'.repeat(letters) } },
})

/** More than a project may hold. */
export const tooMuch: Project = { ...friendship, name: 'n'.repeat(20_001) }
