import { expect, test } from 'vitest'
import { other, readTrial, slotLine, startedFrom, taskOf, trialLine } from './slots.ts'
import { decide } from './update.ts'

const sha256 = 'ab'.repeat(32)
const file = 'botgarten-pi-0.2.0.update'
const stick = { files: ['photos', file], consent: `${sha256}  ${file}\n`, known: [] }

test('an update is installed when a teacher put its checksum beside it', () => {
  expect(decide(stick)).toEqual({ do: 'install', file, sha256 })
  expect(decide({ ...stick, consent: sha256.toUpperCase() })).toEqual({ do: 'install', file, sha256 })
})

test('of the whole list of checksums the update’s own line counts', () => {
  const consent = `${'1'.repeat(64)}  botgarten-pi-0.2.0.img.xz\r\n${sha256}  ${file}\r\n`
  expect(decide({ ...stick, consent })).toEqual({ do: 'install', file, sha256 })
})

test('without a teacher’s word, with two updates or with no checksum nothing is installed', () => {
  expect(decide({ ...stick, consent: null })).toEqual({ do: 'ask' })
  expect(decide({ ...stick, files: [file, 'botgarten-pi-0.3.0.update'] })).toEqual({ do: 'several' })
  expect(decide({ ...stick, consent: 'yes, please' })).toEqual({ do: 'noChecksum' })
})

test('a stick with other files is nobody’s business, and one that stays in is not installed again', () => {
  expect(decide({ ...stick, files: ['photos', 'botgarten.zip'] })).toEqual({ do: 'nothing' })
  expect(decide({ ...stick, known: ['', sha256] })).toEqual({ do: 'nothing' })
})

test('a system tries itself only where it was wanted; the other one notes that it failed', () => {
  expect(taskOf('b', readTrial('running b\n'))).toBe('try')
  expect(taskOf('a', readTrial('running b\n'))).toBe('failed')
  expect(taskOf('a', readTrial('wanted b\n   '))).toBe('failed')
  for (const text of ['', 'kept b\n', 'failed b\n', 'running c'])
    expect(taskOf('b', readTrial(text))).toBe('nothing')
})

test('what is written is read again, and slot.txt keeps its length', () => {
  for (const state of ['wanted', 'running', 'kept', 'failed'] as const)
    for (const slot of ['a', 'b'] as const)
      expect(readTrial(trialLine({ state, slot }).padEnd(12))).toEqual({ state, slot })
  expect(slotLine('a').length).toBe(slotLine('b').length)
  expect(other(other('a'))).toBe('a')
})

test('the kernel’s command line says from where it was started', () => {
  const line = 'console=tty1 root=PARTUUID=b07a9a27-03 ro quiet botgarten.slot=b\n'
  expect(startedFrom(line)).toEqual({ disk: 'b07a9a27', slot: 'b' })
  expect(startedFrom('root=/dev/sda1 ro')).toBe(null)
})
