import { globSync, readdirSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { inHouse } from '../prepare/house.mjs'
import { roomsIn } from './rooms.ts'
import { filesOf } from './sample.ts'

const house = inHouse('.')
const rooms = roomsIn(house)
const foldersIn = (path: string) =>
  readdirSync(inHouse(path), { withFileTypes: true }).flatMap((one) => (one.isDirectory() ? one.name : []))
const filesIn = (pattern: string) =>
  globSync(pattern, { cwd: house }).map((path) => path.replaceAll('\\', '/'))

describe('every folder is a room by existing:', () => {
  test.each(foldersIn('packages'))('packages/%s', (name) => {
    expect(rooms.map((room) => room.name)).toContain(`packages/${name}`)
  })
  test.each(foldersIn('apps/web/src/features'))('features/%s', (name) => {
    expect(rooms.map((room) => room.name)).toContain(`features/${name}`)
  })
})

test('all code of packages can be changed, and all models of features', () => {
  const changed = new Set(rooms.flatMap((room) => filesOf(house, room)))
  const isCode = (path: string) =>
    !/\.(test|d)\.ts$|\/testing\.ts$|\/(generated|testing|reference|node_modules)\//.test(path)
  const all = filesIn('packages/**/*.{ts,mjs}').filter(isCode)
  const models = filesIn('apps/web/src/features/**/*.ts')
    .filter(isCode)
    .filter((path) => !/\/view\/|\/(feature|lazy|new-worker)\.ts$/.test(path))
  expect([...all, ...models].filter((path) => !changed.has(path))).toEqual([])
  expect([all.length > 700, models.length > 250]).toEqual([true, true])
})

test.each(rooms)('$name changes only code, and runs only tests that are there', (room) => {
  expect(filesOf(house, room).filter((file) => /\.test\.ts$|generated|testing/.test(file))).toEqual([])
  const tests = room.tests.flatMap((folder) => filesIn(`${folder}/**/*.test.ts`))
  for (const one of room.walking) expect(tests).toContain(one)
})

test('60 are drawn of what must not be lost, 25 of every other room', () => {
  const saved = rooms.filter(({ group }) => group === 'saved')
  expect(saved.map(({ name, sample }) => [name, sample])).toEqual([
    ['packages/classroom', 60],
    ['web/storage', 60],
  ])
  expect(new Set(rooms.filter((room) => !saved.includes(room)).map(({ sample }) => sample))).toEqual(
    new Set([25]),
  )
})
