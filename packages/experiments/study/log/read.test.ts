import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import * as fc from 'fast-check'
import { content } from '@botgarten/content/files'
import { expect, test } from 'vitest'
import { most, readLog, replay } from '../index.ts'

const sample = readFileSync(join(import.meta.dirname, '../reference/log.jsonl'), 'utf8')
const lines = sample.trim().split('\n')
const open = lines.find((line) => line.includes('"event":"open"'))!

test('a log that Botgarten wrote is read whole', () => {
  const read = readLog(sample)
  expect(read.faults).toEqual([])
  expect(read.lines).toHaveLength(lines.length)
})

test.each(['null', '5', '"session"', '[]', '{'])('a line that is no object is refused: %s', (line) => {
  expect(readLog(line)).toEqual({ lines: [], faults: [{ line: 1, reason: 'notJson', facts: {} }] })
})

/** One run of it. */
const short = lines.slice(0, 1 + lines.findIndex((line) => line.includes('"event":"end"'))).join('\n')

/** Letters put in, taken out or exchanged, lines lost, doubled or moved. */
const changed = fc
  .array(
    fc.record({
      at: fc.double({ min: 0, max: 1, noNaN: true }),
      how: fc.constantFrom('cut', 'letter', 'number', 'line', 'twice', 'null'),
      text: fc.oneof(fc.string({ maxLength: 8 }), fc.constantFrom('{', '"', '[', '1e999', '__proto__', '-1')),
    }),
    { minLength: 1, maxLength: 4 },
  )
  .map((changes) => changes.reduce(mutated, short))

function mutated(text: string, { at, how, text: put }: { at: number; how: string; text: string }): string {
  const place = Math.floor(at * text.length)
  const all = text.split('\n')
  const row = Math.floor(at * all.length)
  if (how === 'cut') return text.slice(0, place)
  if (how === 'line') return all.toSpliced(row, 1).join('\n')
  if (how === 'twice') return all.toSpliced(row, 0, all[row] ?? '').join('\n')
  if (how === 'number') return text.slice(0, place) + text.slice(place).replace(/-?\d+/, put)
  if (how === 'null') return text.slice(0, place) + text.slice(place).replace(/:("[^"]*"|\d+)/, ':null')
  return text.slice(0, place) + put + text.slice(place + put.length)
}

test('2,000 changed files are read line by line, and what is read can be played or is refused', () => {
  let played = 0
  fc.assert(
    fc.property(changed, (text) => {
      const { lines, faults } = readLog(text)
      const last = text.split('\n').length
      for (const { line, reason } of faults) {
        expect(line).toBeGreaterThanOrEqual(1)
        expect(line).toBeLessThanOrEqual(last)
        expect(reason).toMatch(/^[a-zA-Z]+$/)
      }
      // Every fiftieth is played too; a stretch of hours would say no more.
      played += 1
      if (played % 50 !== 0 || lines.some(({ says }) => says.event === 'time' && says.ticks > 2000)) return
      const { runs } = replay(lines, { floorOf: content.floorOf, checksOf: () => [] })
      expect(runs.length).toBe(lines.filter(({ says }) => says.event === 'end').length)
    }),
    { seed: 22, numRuns: 2000 },
  )
})

const replaced = (line: string, from: string | RegExp, to: string) => {
  const text = line.replace(from, to)
  expect(text).not.toBe(line)
  return text
}

test.each([
  ['a line that is no JSON', `${lines[0]!}\n{"t":1`, 'notJson', 2],
  [
    'an event that is not in the code book',
    replaced(lines[0]!, '"event":"session"', '"event":"spy"'),
    'noEvent',
    1,
  ],
  ['another format', replaced(lines[0]!, '"format":1', '"format":2'), 'format', 1],
  [
    'a field that is not in the code book',
    replaced(lines[0]!, '"format"', '"name":"x","format"'),
    'field',
    1,
  ],
  ['a session without its first line', lines[1]!, 'noSession', 1],
  ['another pseudonym', `${lines[0]!}\n${replaced(lines[1]!, '0101D', '0102X')}`, 'otherChild', 2],
  [
    'a line before the one above',
    `${replaced(lines[0]!, '"t":0', '"t":99')}\n${replaced(lines[1]!, /"t":\d+/, '"t":1')}`,
    'timeBack',
    2,
  ],
  [
    'a world without a robot',
    `${lines[0]!}\n${replaced(open, /"robots":\[.*?\]\}?,"brains"/, '"robots":[]},"brains"')}`,
    'field',
    2,
  ],
  [
    'a key that reaches into every object',
    `${lines[0]!}\n${replaced(open, '"brains":{', '"brains":{"__proto__":{},')}`,
    'field',
    2,
  ],
  [
    'a line of six million letters',
    `${lines[0]!}\n${' '.repeat(1)}${'x'.repeat(most.line + 1)}`,
    'tooLong',
    2,
  ],
])('%s is refused', (_, text, reason, line) => {
  expect(readLog(text).faults[0]).toMatchObject({ line, reason })
})

test('more than eight hours of simulated time are refused', () => {
  const [head] = lines
  const time = (t: number) =>
    JSON.stringify({
      t,
      session: 's5e55104a',
      pseudonym: '0101D',
      event: 'time',
      ticks: 1_000_000,
      practising: false,
    })
  const text = [head, time(1), time(2)].map((line) =>
    line!.replace(/"session":"s[0-9a-f]{8}"/, '"session":"s5e55104a"'),
  )
  expect(readLog(text.join('\n')).faults).toEqual([{ line: 3, reason: 'tooMuchTime', facts: {} }])
})
