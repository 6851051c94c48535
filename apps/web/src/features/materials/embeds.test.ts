import { readFileSync, readdirSync } from 'node:fs'
import { expect, test } from 'vitest'

const folder = new URL('.', import.meta.url)
const source = readFileSync(new URL('../../../../../packages/content/schema/embed.ts', folder), 'utf8')
const kinds = [...source.matchAll(/kind: v\.literal\('(\w+)'\)/g)].map(([, kind]) => kind!)
const drawn = readdirSync(new URL('embeds/', folder)).map((file) => file.replace(/\.svelte$/, ''))

test('whatever a text may name is drawn by a file of its kind', () => {
  expect(kinds.length).toBeGreaterThan(15)
  expect(drawn.sort()).toEqual(kinds.sort())
})
