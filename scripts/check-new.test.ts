import { existsSync } from 'node:fs'
import { expect, test } from 'vitest'
import { kinds, testsOf } from './check-new.ts'
import { inHouse } from './prepare/house.mjs'
import { Trouble } from './prepare/run.mjs'

const members = { block: 'math_number', card: 'friendship', map: 'city', pane: 'robot', language: 'de' }

test('there is an example of every kind', () => {
  expect(Object.keys(members)).toEqual(Object.keys(kinds))
})

test.each(Object.entries(members))('the tests of a %s such as %s are there', (kind, name) => {
  const [files] = [testsOf(kind, name).slice(0, kinds[kind]!.tests.length)]
  expect(files.length).toBeGreaterThan(0)
  expect(files.filter((file) => !existsSync(inHouse(file)))).toEqual([])
})

test('a member or a kind that does not exist is named, not passed over', () => {
  expect(() => testsOf('card', 'friendships')).toThrow(Trouble)
  expect(() => testsOf('card', '')).toThrow('npm run check:new')
  expect(() => testsOf('toString', 'friendship')).toThrow('npm run check:new')
})
