import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { readReached, ReachedRecord } from './reached.ts'

let folder: string
beforeEach(() => void (folder = mkdtempSync(join(tmpdir(), 'botgarten-reached-'))))
afterEach(() => rmSync(folder, { recursive: true, force: true }))

const own = ['http://localhost:4173', 'http://192.168.0.5:4173', 'http://[2001:db8::7]:4173']

test('only another device counts, by the time and without its address', () => {
  const record = new ReachedRecord(folder)
  record.startAt(own)
  for (const address of ['127.0.0.1', '::1', '192.168.0.5', '2001:db8::7']) record.note(address, 5)
  expect(readReached(folder)).toEqual({ addresses: own, otherDevice: null })
  record.note('192.168.0.9', 7)
  expect(readReached(folder)).toEqual({ addresses: own, otherDevice: 7 })
  expect(new ReachedRecord(folder).otherDevice).toBe(7)
})

test('it is written once an hour, and again when the clock was set back', () => {
  const record = new ReachedRecord(folder)
  const seen = [1000, 2000, 3_602_000, 500].map((now) => {
    record.note('192.168.0.9', now)
    return record.otherDevice
  })
  expect(seen).toEqual([1000, 1000, 3_602_000, 500])
})

test('devices are counted for as long as they ask, and written down nowhere', () => {
  const record = new ReachedRecord(folder)
  record.startAt(own)
  for (const at of [1, 2, 3]) record.note(`192.168.0.${at}`, at * 1000)
  record.note('192.168.0.5', 3000)
  expect(record.devices(4000)).toBe(3)
  expect(record.devices(302_500)).toBe(1)
  expect(JSON.stringify(readReached(folder))).not.toContain('192.168.0.3')
})

test('a record that was cut off counts as none', () => {
  writeFileSync(join(folder, 'reached.json'), '{"addr')
  expect(readReached(folder)).toEqual({ addresses: [], otherDevice: null })
})
