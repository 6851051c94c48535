import { content } from '@botgarten/content/files'
import { networks } from '@botgarten/programs'
import { describe, expect, test } from 'vitest'
import { readExamples, type Helps, type Read } from './files.ts'

const net = networks(content.program('friendship', 'start')!.programs['main']!)[0]!
const heading = 'eyeLeft,eyeRight,wheelLeft,wheelRight'
const lines = (count: number, line: (k: number) => string) => Array.from({ length: count }, (_, k) => line(k))
const csv = (...rows: readonly string[]) => [heading, ...rows].join('\n')
const read = (text: string, helps?: Helps, name = 'rows.csv'): Promise<Read> =>
  readExamples(new File([text], name), net, helps)
const countIn = (found: Read) => (found.kind === 'examples' ? found.examples.rows.length : found)

describe('a table in which something is no number', () => {
  test.each(['x', '', 'NaN', '1e999', '-Infinity'])(
    'names row and column of "%s", and offers to leave such rows out',
    async (cell) => {
      const text = csv('1,2,3,4', `5,${cell},7,8`, '9,10,11,12', `${cell},1,1,1`)
      const facts = { row: 3, column: 2, cell }
      expect(await read(text)).toEqual({
        ...{ kind: 'refused', problem: 'table.noNumber', facts },
        offer: { help: 'leaveOut', count: 2 },
      })
      const rest = await read(text, { leaveOut: true })
      expect(countIn(rest)).toBe(2)
      expect(rest).toMatchObject({ examples: { rows: [{ 6: 1 }, { 6: 9 }] } })
    },
  )

  test('has no such offer where no row would be left', async () => {
    expect(await read(csv('a,2,3,4', '5,6,7,b'))).not.toHaveProperty('offer')
    expect(await read(csv('a,2,3,4', '5,6,7,b'), { leaveOut: true })).toMatchObject({ kind: 'refused' })
  })

  test('may also have rows that are too short', async () => {
    const text = csv('1,2,3,4', '5,6,7')
    expect(await read(text)).toMatchObject({ problem: 'table.unequalRows', offer: { count: 1 } })
    expect(countIn(await read(text, { leaveOut: true }))).toBe(1)
  })
})

describe('a file of too much', () => {
  const many = csv(...lines(6000, (k) => `${k % 100},2,3,4`))

  test('6,000 rows are refused with the limit, and the first 5,000 are taken where that is wanted', async () => {
    const refused = await read(many)
    expect(refused).toMatchObject({ problem: 'table.manyRows', facts: { most: 5000 } })
    expect(refused).toMatchObject({ offer: { help: 'first', count: 5000 } })
    expect(countIn(await read(many, { first: true }))).toBe(5000)
  })

  test('10 MB too, of which only whole lines are read', async () => {
    const long = csv(...lines(10_000, (k) => `${k % 100},2,3,4${' '.repeat(1000)}`))
    expect(long.length).toBeGreaterThan(10_000_000)
    expect(await read(long)).toMatchObject({
      problem: 'tooBig',
      facts: { most: 5 },
      offer: { help: 'first' },
    })
    const first = await read(long, { first: true })
    expect(countIn(first)).toBeGreaterThan(4900)
    expect(first).toMatchObject({ outside: 0 })
  })

  test('of 300 drives the first 200 are taken', async () => {
    const drives = [`${heading},drive`, ...lines(300, (k) => `1,2,3,4,${k}`)].join('\n')
    expect(await read(drives)).toMatchObject({ problem: 'manyDrives', facts: { most: 200 } })
    expect(await read(drives, { first: true })).toMatchObject({ examples: { drives: { length: 200 } } })
  })

  test('one help after the other: too many rows, and one of them is bad', async () => {
    const text = `${many}\n`.replace('50,2,3,4', '50,x,3,4')
    expect(await read(text, { first: true })).toMatchObject({ offer: { help: 'leaveOut', count: 1 } })
    expect(countIn(await read(text, { first: true, leaveOut: true }))).toBe(4999)
  })

  test('a JSON file of 6,000 rows and 300 drives gives the first of both', async () => {
    const kinds = (all: typeof net.inputs) => all.map(({ id, type }) => ({ id, kind: type, port: '' }))
    const neurons = { inputs: kinds(net.inputs), outputs: kinds(net.outputs) }
    const drives = Array.from({ length: 300 }, (_, k) => ({ id: `d${k}`, by: 'pad', seed: 1 }))
    const rows = Array.from({ length: 6000 }, (_, k) => [k % 300, k, 0, 0, 0, 1, 1, 2, 3, 4])
    const text = JSON.stringify({ botgarten: 'examples', version: 1, neurons, drives, rows })
    expect(await read(text, {}, 'rows.json')).toMatchObject({ problem: 'manyRows', offer: { help: 'first' } })
    expect(await read(text, { first: true }, 'rows.json')).toMatchObject({
      examples: { drives: { length: 200 }, rows: { length: 4000 } },
    })
  })
})

describe('a table of other columns', () => {
  test('in another order is read by its names', async () => {
    expect(await read('wheelRight;wheelLeft;eyeRight;eyeLeft\n1;2;3;4,5\n')).toMatchObject({
      examples: { rows: [{ 6: 4.5, 7: 3, 8: 2, 9: 1 }] },
    })
  })

  test.each(['a,b,c,d\n1,2,3,4', `${heading},speed\n1,2,3,4,5`, 'eyeLeft,eyeRight\n1,2', '1,2,3,4\n5,6,7,8'])(
    'asks which is which: %s',
    async (text) => expect(await read(text)).toMatchObject({ kind: 'columns' }),
  )

  test('numbers outside are read as they are, wheels are cut, and that is counted', async () => {
    expect(await read(csv('120,-5,300,40'))).toMatchObject({
      ...{ kind: 'examples', outside: 3 },
      examples: { rows: [{ 6: 120, 7: -5, 8: 100, 9: 40 }] },
    })
  })
})
