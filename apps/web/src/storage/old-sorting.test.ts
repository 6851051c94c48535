import { readFileSync } from 'node:fs'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { Playground } from '#features/sorting/model/playground.svelte.ts'
import { moveOldSorting } from './old-sorting.ts'
import { list, save } from './projects.ts'
import { fillDisk, freshDevice } from './testing/device.ts'
import { freshLocalStorage } from './testing/local.ts'
import { friendship } from './testing/sample.ts'

/** The setting as the browser profile of an earlier version has it. */
const { localStorage } = JSON.parse(
  readFileSync(new URL('../../../../e2e/samples/a62d0d78/profile.json', import.meta.url), 'utf8'),
) as { readonly localStorage: { readonly [key: string]: string } }
const key = 'botgarten.sorting'
const old = localStorage[key]!

let settings: Map<string, string>
beforeEach(async () => {
  await freshDevice()
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  settings = freshLocalStorage()
  settings.set(key, old)
})
afterEach(() => void vi.unstubAllGlobals())

async function sortings() {
  await moveOldSorting()
  const { projects } = await list()
  return projects.flatMap(({ id, project }) => (project.playground ? [{ id, project }] : []))
}

test('sorted work of an earlier version is a project at the first look, with all of it', async () => {
  const [{ id, project } = { id: '', project: friendship }, ...others] = await sortings()
  expect([id, project.name, project.botgarten, others]).toEqual(['sorting', 'sorting', 5, []])
  expect(project.sorting).toEqual(JSON.parse(old))
  expect(settings.has(key)).toBe(false)
  const kept: unknown = project.sorting
  const playground = new Playground({ kept, keep() {}, flush() {}, close() {} })
  expect([playground.unread, playground.work.table.rows.length, playground.nameOf(1)]).toEqual([
    ...[false, 7, 'Mine'],
  ])
  playground.turnTo('things')
  expect(playground.nameOf(0)).toBe('Bottles')
  playground.turnTo('readings')
  expect(playground.work.table.rows.length).toBeGreaterThan(0)
})

test('without room on the device the setting stays, and becomes a project later', async () => {
  const makeRoom = fillDisk()
  expect(await sortings()).toEqual([])
  expect(settings.get(key)).toBe(old)
  makeRoom()
  expect(await sortings()).toHaveLength(1)
  expect(settings.has(key)).toBe(false)
})

test('a project that is there stays as it is: the work becomes a second one, and none twice', async () => {
  const [first] = await sortings()
  const mine = { ...first!.project, sorting: { source: 'points' } }
  await save('sorting-mine', mine, 0)
  settings.set(key, old)
  expect(await sortings()).toHaveLength(2)
  settings.set(key, JSON.stringify({ source: 'things' }))
  expect((await sortings()).map(({ project }) => project.sorting)).toContainEqual({ source: 'things' })
  expect(await sortings()).toHaveLength(3)
  expect(settings.has(key)).toBe(false)
})

test('two looks at once make one project', async () => {
  await Promise.all([sortings(), sortings()])
  expect(await sortings()).toHaveLength(1)
})

test.each(['not json', '"text"', 'null'])('what is no such work stays where it is: %s', async (text) => {
  settings.set(key, text)
  expect(await sortings()).toEqual([])
  expect(settings.get(key)).toBe(text)
})
