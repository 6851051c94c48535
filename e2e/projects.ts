import { readFileSync } from 'node:fs'

const folders = { friendship: '05-friendship', fear: '06-fear' }

const read = (path: string) =>
  JSON.parse(readFileSync(new URL(`../content/${path}`, import.meta.url), 'utf8')) as object

/** The text of a project file, as a child would have saved it from a card. */
export function projectFile(card: keyof typeof folders, program: string): string {
  const project = {
    ...{ botgarten: 1, name: card, card, assets: {} },
    ...read(`cards/network/${folders[card]}/${program}.json`),
    world: read(`worlds/${card}/world.json`),
  }
  return JSON.stringify(project)
}
