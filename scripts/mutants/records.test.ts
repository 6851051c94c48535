import { appendFileSync, existsSync, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { inHouse } from '../prepare/house.mjs'
import { Records, testsHash } from './records.ts'

let folder: string
let file: string
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'botgarten-records-'))
  file = join(folder, 'below', 'mutants.jsonl')
})
afterEach(() => rmSync(folder, { recursive: true }))

const mutant = (text: string) => ({ file: 'a.ts', line: 1, was: 'a', change: 'a → b', text })

test('a later run knows what came of a mutant, by the file with its fault', () => {
  const first = new Records(file)
  expect(first.outcomeOf(mutant('b'), 'tests')).toBeNull()
  first.add(mutant('b'), 'tests', 'killed')
  first.add(mutant('c'), 'tests', 'survived')
  const second = new Records(file)
  expect(['b', 'c', 'd'].map((text) => second.outcomeOf(mutant(text), 'tests'))).toEqual([
    'killed',
    'survived',
    null,
  ])
  expect(second.outcomeOf({ ...mutant('b'), file: 'other.ts' }, 'tests')).toBeNull()
})

test('one that survived is tried again once the tests have changed; the last result counts', () => {
  const records = new Records(file)
  records.add(mutant('b'), 'old', 'unasked')
  records.add(mutant('c'), 'old', 'timeout')
  expect(records.outcomeOf(mutant('b'), 'new')).toBeNull()
  expect(records.outcomeOf(mutant('c'), 'new')).toBe('timeout')
  // Until then it counts as it did.
  expect([records.lastOutcomeOf(mutant('b')), records.lastOutcomeOf(mutant('d'))]).toEqual(['unasked', null])
  records.add(mutant('b'), 'new', 'killed')
  expect(new Records(file).outcomeOf(mutant('b'), 'newest')).toBe('killed')
})

test('a line that was cut off is passed over, and all are forgotten when that is wanted', () => {
  const records = new Records(file)
  records.add(mutant('b'), 'tests', 'killed')
  appendFileSync(file, '{"key":"00"}\n{"key":"0123","tes')
  expect(new Records(file).outcomeOf(mutant('b'), 'tests')).toBe('killed')
  records.forget()
  expect([records.outcomeOf(mutant('b'), 'tests'), existsSync(file)]).toEqual([null, false])
  records.forget()
})

test('the hash of tests differs from room to room, and stays the same', () => {
  const hash = (folder: string) => testsHash(inHouse('.'), { tests: [folder], walking: [] })
  expect(hash('packages/maps')).toBe(hash('packages/maps'))
  expect(hash('packages/maps')).not.toBe(hash('packages/numbers'))
})
