// Contract of every feature: its door says whose it is, what it says and what it may weigh, and its part can be had.
import { readFileSync, readdirSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { files } from 'content:words'
import { features } from './features.ts'

const folder = join(import.meta.dirname, '../features')
const ids = readdirSync(folder)
/** Files of messages that every page has before it says anything. */
const always = ['app']

const sourcesIn = (place: string) =>
  readdirSync(place, { recursive: true, encoding: 'utf8' })
    .filter((file) => /\.(svelte|ts)$/.test(file) && !/\.test\.ts$/.test(file))
    .map((file) => readFileSync(join(place, file), 'utf8'))
const sourcesOf = (id: string) => sourcesIn(join(folder, id))

/** Keys of messages that stand in code, and files of messages that it asks for. */
const keysIn = (code: string) => [...code.matchAll(/\b(?:m\[|message\()'([^']+)'/g)].map(([, key]) => key!)
const askedIn = (code: string) =>
  [...code.matchAll(/(?:fetchWords|withWords)\(([^;]*?)\)\s*(?:[;.\]},]|then|$)/gm)].flatMap(([, list]) =>
    [...list!.matchAll(/'([\w-]+)'/g)].map(([, file]) => file!),
  )

const tables = new Map(
  await Promise.all(
    Object.entries(files.en).map(
      async ([file, load]) => [file, Object.keys((await load()).default as object)] as const,
    ),
  ),
)

test.each(ids)('%s has a door that names it, and a budget of its own only above 100 kB', (id) => {
  const feature = features.get(id)
  expect(feature?.id).toBe(id)
  const { budget = Infinity, load } = feature!
  expect(budget).toBeGreaterThan(100_000)
  expect(budget === Infinity || load !== undefined).toBe(true)
})

test.each(ids)('all that %s says is in the files of messages that it names', (id) => {
  const code = sourcesOf(id).join('\n')
  const named = [...always, ...features.get(id)!.words, ...askedIn(code)]
  const there = new Set(named.flatMap((file) => tables.get(file) ?? []))
  expect(keysIn(code).filter((key) => !there.has(key))).toEqual([])
})

/** Where a user gets to a feature: the frame of the app, and its pages. */
const shown = ['.', '../routes']
  .map((place) => sourcesIn(join(import.meta.dirname, place)).join('\n'))
  .join('\n')

test.each(ids)('%s is shown by the app or a page', (id) => {
  expect(shown).toContain(`#features/${id}/feature.ts`)
})

const lazy = [...features.values()].filter(({ load }) => load)
test.each(lazy)('the lazy part of $id can be had, with something in it', async ({ load }) => {
  expect(Object.keys((await load!()) as object)).not.toEqual([])
})
