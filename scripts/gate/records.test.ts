import { appendFileSync, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { beforeEach, afterEach, expect, test } from 'vitest'
import { addRecord, flakyOf, forgetRun, readRecords } from './records.mjs'

let folder = ''
let file = ''
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'botgarten-records-'))
  file = join(folder, 'deep', 'green.jsonl')
})
afterEach(() => rmSync(folder, { recursive: true, force: true }))

const flaky = { name: 'a.spec.ts › Bo drives', failure: 'Bo stands.' }
const green = (key: string, run: string, tests = [flaky]) => ({ key, run, passed: 3, flaky: tests })

test('there are no records before the first, and none are written without a file', () => {
  expect(readRecords(file).size).toBe(0)
  addRecord(null, green('a', 'full'))
  expect(readRecords(null).size).toBe(0)
})

test('a record is found by its key', () => {
  addRecord(file, green('a', 'full'))
  addRecord(file, green('b', 'full'))
  expect(readRecords(file).get('b')).toEqual(green('b', 'full'))
})

test('a line that was cut off is left out, and the others are read', () => {
  addRecord(file, green('a', 'full'))
  appendFileSync(file, '{"key":"b","pas')
  expect([...readRecords(file).keys()]).toEqual(['a'])
})

test('flaky tests of all shards of a run are added up, and no others', () => {
  addRecord(file, green('a', 'run 1'))
  addRecord(file, green('b', 'run 1', []))
  addRecord(file, green('c', 'run 2'))
  expect(flakyOf(file, 'run 1')).toEqual([flaky])
})

test('a run that starts again discards its own records alone', () => {
  addRecord(file, green('a', 'run 1'))
  addRecord(file, green('b', 'run 2'))
  forgetRun(file, 'run 1')
  addRecord(file, green('c', 'run 1'))
  expect([...readRecords(file).keys()]).toEqual(['b', 'c'])
})
