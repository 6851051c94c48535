import { blockFrom } from '@botgarten/blocks'
import { mostOf, noExamples, withDrive, type Examples } from '@botgarten/learning/neural-network/examples'
import { sample } from '@botgarten/numbers/testing'
import { cardConfig } from '@botgarten/simulation'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { distanceNeuron, motorNeuron, network as netBlock, start } from '../../blocks/parts/examples.ts'
import { networks } from '../networks.ts'
import { parseProject } from '../project/index.ts'
import type { NetworkOutline, Program } from '../types.ts'
import {
  choiceIn,
  ExamplesError,
  examplesCsv,
  examplesFile,
  examplesFromTable,
  fitExamples,
  joinExamples,
  mirrorIn,
  parseExamplesFile,
  wheelsIn,
} from './index.ts'

type Neurons = Parameters<typeof netBlock>[0]

/** A program whose blocks are called b0, b1, … */
function outlineOf(inputs: Neurons, outputs: Neurons): NetworkOutline {
  let ids = 0
  const fresh = () => `b${ids++}`
  const blocks = [start, netBlock(inputs, outputs)].map((template) => blockFrom(template, fresh))
  const program: Program = { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } }
  return networks(program)[0]!
}

const net = outlineOf([distanceNeuron('2'), distanceNeuron('3')], [motorNeuron('C'), motorNeuron('B')])
const ids = (neurons: NetworkOutline['inputs']) => neurons.map(({ id }) => id)
const [inputs, outputs] = [ids(net.inputs), ids(net.outputs)]
const pose = { x: 10, y: 20, heading: 90 }
const shown = (l: number, r: number, m: number, n: number) => ({
  ...{ tick: 6, pose, inputs: [l, r], outputs: [m, n] },
})
const examples: Examples = [1, 2, 3].reduce(
  (all, k) =>
    withDrive(all, { id: `drive ${k}`, by: 'pad', seed: k }, [
      shown(10 * k, 90, 30, 60.25),
      shown(55, k, -20, 0),
    ]).examples,
  noExamples(inputs, outputs),
)
const text = JSON.stringify(examplesFile(examples, net))

function problemOf(act: () => unknown): unknown {
  try {
    act()
  } catch (error) {
    expect(error).toBeInstanceOf(ExamplesError)
    const { problem, facts } = error as ExamplesError
    return Object.keys(facts).length > 0 ? [problem, facts] : problem
  }
}

describe('examples as a file', () => {
  it('come back as they were', () => {
    expect(fitExamples(parseExamplesFile(text), net)).toEqual(examples)
  })

  it.each(['hand', 'keys', 'pad', 'touch', 'coach', 'program', 'file'] as const)(
    'come back as they were, too, where they were shown by %s',
    (by) => {
      const drive = { id: 'own', by, seed: 1 }
      const own = withDrive(noExamples(inputs, outputs), drive, [shown(10, 90, 30, 60)]).examples
      const file = JSON.stringify(examplesFile(own, net))
      expect(fitExamples(parseExamplesFile(file), net)).toEqual(own)
    },
  )

  it('fit a network whose neurons are of the same kinds in their order, and no other', () => {
    const file = parseExamplesFile(text.replaceAll(inputs[0]!, 'other').replaceAll(outputs[1]!, 'another'))
    expect(fitExamples(file, net)).toEqual(examples)
    const three = outlineOf([distanceNeuron('2')], [motorNeuron('C'), motorNeuron('B')])
    expect(problemOf(() => fitExamples(file, three))).toEqual([
      'otherNetwork',
      { there: '2 → 2', here: '1 → 2' },
    ])
  })

  it('say of each neuron its kind and its port, so that others can be distinguished', () => {
    const { neurons } = examplesFile(examples, net)
    expect(neurons.inputs.map(({ port }) => port)).toEqual(['ULTRASONIC_PORT_2', 'ULTRASONIC_PORT_3'])
    expect(neurons.outputs.map(({ port }) => port.at(-1))).toEqual(['C', 'B'])
  })

  it('are put behind others, their drives by names of their own', () => {
    const joined = joinExamples(examples, examples)
    expect(joined.rows).toHaveLength(12)
    expect(joined.drives.map(({ id }) => id).slice(3)).toEqual(['drive 1 2', 'drive 2 2', 'drive 3 2'])
    expect(joined.rows[6]).toEqual([3, ...examples.rows[0]!.slice(1)])
    const full = { ...examples, rows: Array.from({ length: 4999 }, () => examples.rows[0]!) }
    expect(problemOf(() => joinExamples(full, examples))).toEqual(['manyRows', { most: 5000 }])
  })

  it('are refused in one word where they are none', () => {
    const changed = (change: object) => JSON.stringify({ ...(JSON.parse(text) as object), ...change })
    const row = examples.rows[0]!
    const refused = (change: object) => problemOf(() => parseExamplesFile(changed(change)))
    expect(problemOf(() => parseExamplesFile('{'))).toBe('notJson')
    expect(problemOf(() => parseExamplesFile('[]'))).toBe('notExamples')
    expect(problemOf(() => parseExamplesFile('null'))).toBe('notExamples')
    expect(problemOf(() => parseExamplesFile('{"botgarten":1}'))).toBe('isAProject')
    expect(problemOf(() => parseExamplesFile(`${text.slice(0, -1)},"__proto__":{}}`))).toBe('notExamples')
    expect(problemOf(() => parseExamplesFile(' '.repeat(10_000_000)))).toEqual(['tooBig', { most: 5 }])
    expect(refused({ rows: Array.from({ length: 6000 }, () => row) })).toEqual(['manyRows', { most: 5000 }])
    expect(refused({ drives: Array.from({ length: 300 }, () => ({})) })).toEqual([
      'manyDrives',
      { most: 200 },
    ])
    expect(refused({ rows: [row, row.slice(1)] })).toEqual(['badRow', { row: 2 }])
    expect(refused({ rows: [row.with(0, 3)] })).toEqual(['badRow', { row: 1 }])
    expect(refused({ rows: [row.with(5, 2)] })).toEqual(['badRow', { row: 1 }])
    expect(refused({ rows: [row.with(7, 1e300)] })).toEqual(['badRow', { row: 1 }])
    expect(refused({ rows: [['0', ...row.slice(1)]] })).toEqual(['badRow', { row: 1 }])
    expect(refused({ drives: [examples.drives[0], examples.drives[0]], rows: [] })).toBe('notExamples')
  })

  it('belong to a project', () => {
    const brain = { kind: 'network', layers: [[], []], weights: {}, sets: {}, examples }
    const project = {
      ...{ botgarten: 1, name: '', programs: { main: { stacks: [], config: { stacks: [] } } }, assets: {} },
      brains: { net: brain },
      world: {
        ...{ size: { width: 100, height: 100 }, floor: { colour: '#FFFFFF' }, areas: [], lines: [] },
        obstacles: [],
        robots: [{ id: 'bo', program: 'main', brain: '', pose, config: cardConfig }],
      },
    }
    expect(parseProject(JSON.stringify(project)).brains['net']!.examples).toEqual(examples)
    const rows = [examples.rows[0]!.slice(2)]
    expect(() =>
      parseProject({ ...project, brains: { net: { ...brain, examples: { ...examples, rows } } } }),
    ).toThrow()
    const many = {
      ...brain,
      examples: { ...examples, rows: Array(mostOf.rows).fill(examples.rows[0]) as Examples['rows'] },
    }
    const networks = (count: number) =>
      Object.fromEntries(Array.from({ length: count }, (_, k) => [`net${k}`, many]))
    const all = mostOf.projectRows / mostOf.rows
    expect(() => parseProject({ ...project, brains: networks(all) })).not.toThrow()
    expect(() => parseProject({ ...project, brains: { ...networks(all), more: brain } })).toThrow()
  })
})

describe('examples as a table', () => {
  const columns = [...inputs, ...outputs]

  it('come back from their CSV, whatever they are', () => {
    const percent = fc.integer({ min: 0, max: 10_000 }).map((value) => value / 100)
    const wish = fc.integer({ min: -10_000, max: 10_000 }).map((value) => value / 100)
    const row = fc.tuple(percent, percent, wish, wish, fc.constantFrom(0, 1))
    fc.assert(
      fc.property(fc.array(row, { minLength: 1, maxLength: 20 }), (rows) => {
        const table = { columns: [...columns, 'on'], rows }
        const { examples: read, outside } = examplesFromTable(table, inputs, outputs)
        const lines = examplesCsv(read, true).trim().split('\r\n')
        expect(lines[0]).toBe([...columns, 'drive', 'on'].join(','))
        const numbers = lines.slice(1).map((line) => line.split(',').map(Number))
        expect(
          examplesFromTable({ columns: [...columns, 'drive', 'on'], rows: numbers }, inputs, outputs),
        ).toEqual({
          examples: read,
          outside,
        })
        expect(examplesCsv(read).trim().split('\r\n')).toHaveLength(
          1 + rows.filter((one) => one[4] === 1).length,
        )
      }),
      { seed: 5 },
    )
  })

  it('name their columns in any order; what is beyond the range is said, and wishes are cut', () => {
    const table = { columns: [...columns].reverse(), rows: [[120, -150, 40, 300]] }
    const { examples: read, outside } = examplesFromTable(table, inputs, outputs)
    expect(read.rows[0]!.slice(6)).toEqual([300, 40, -100, 100])
    expect(outside).toBe(3)
  })

  it('count a number as beyond the range from the first bit over 0 to 100, or −100 to 100', () => {
    const columns = [...inputs, ...outputs]
    const outsideOf = (...row: number[]) =>
      examplesFromTable({ columns, rows: [row] }, inputs, outputs).outside
    expect([outsideOf(0, 100, -100, 100), outsideOf(0, 100.5, 0, 0), outsideOf(-0.5, 0, 100.5, 0)]).toEqual([
      0, 1, 2,
    ])
  })

  it('are refused where a column is unknown, missing, there twice or has no name', () => {
    const refused = (names: readonly string[], rows: readonly number[][] = [[1, 2, 3, 4, 5]]) =>
      problemOf(() => examplesFromTable({ columns: names, rows }, inputs, outputs))
    expect(refused([...columns, 'speed'])).toEqual([
      'unknownColumn',
      { column: 'speed', known: [...columns, 'drive', 'on'].join(', ') },
    ])
    expect(refused(columns.slice(1))).toEqual(['missingColumn', { column: columns[0] }])
    expect(refused([...columns, columns[0]!])).toEqual(['twiceColumn', { column: columns[0] }])
    expect(refused(['1', '2', '3', '4'])).toEqual(['noHeading', { known: columns.join(', ') }])
    expect(
      refused(
        columns,
        Array.from({ length: 6000 }, () => [1, 2, 3, 4]),
      ),
    ).toEqual(['manyRows', { most: 5000 }])
    const drives = Array.from({ length: 300 }, (_, k) => [1, 2, 3, 4, k])
    expect(refused([...columns, 'drive'], drives)).toEqual(['manyDrives', { most: 200 }])
  })
})

describe('left and right of a network', () => {
  const inMirror = (eyes: Neurons, wheels: Neurons) => mirrorIn(outlineOf(eyes, wheels), cardConfig)
  const lamp = { type: 'ai_nn_output_node_led' as const, fields: { OUTPUTNODE: '#00642E' } }
  const word = { type: 'ai_nn_output_node_text' as const, fields: { OUTPUTNODE: 'red' } }

  it('change places: the two eyes, the two wheels', () => {
    expect(mirrorIn(net, cardConfig)).toEqual({ inputs: [1, 0], outputs: [1, 0] })
    expect(
      inMirror([distanceNeuron('3'), distanceNeuron('2')], [motorNeuron('B'), lamp, motorNeuron('C')]),
    ).toEqual({
      inputs: [1, 0],
      outputs: [2, 1, 0],
    })
  })

  it('have no mirror where one lacks its partner or nothing has a side', () => {
    expect(inMirror([distanceNeuron('2')], [motorNeuron('C'), motorNeuron('B')])).toBeNull()
    expect(inMirror([distanceNeuron('2'), distanceNeuron('3')], [motorNeuron('C')])).toBeNull()
    expect(inMirror([distanceNeuron('4')], [motorNeuron('C'), motorNeuron('B')])).toBeNull()
  })

  it('say which outputs drive, and how lamps and words are right', () => {
    expect(wheelsIn(net, cardConfig)).toEqual({ left: 0, right: 1 })
    expect(wheelsIn(outlineOf([distanceNeuron('2')], [motorNeuron('C')]), cardConfig)).toBeNull()
    expect(choiceIn(outlineOf([distanceNeuron('2')], [lamp, lamp]))).toBe('one')
    expect(choiceIn(outlineOf([distanceNeuron('2')], [word]))).toBe('each')
    expect(choiceIn(outlineOf([distanceNeuron('2')], [word, lamp]))).toBeNull()
  })
})

describe('damaged files', () => {
  const seeds = sample(
    Array.from({ length: 10_000 }, (_, k) => k),
    100,
  )
  const odd = [
    '',
    '"',
    '{',
    ']',
    '-',
    '1e999',
    'NaN',
    'null',
    '__proto__',
    '0',
    '9'.repeat(40),
    '\u0000',
    '[[',
    ',,',
    'true',
  ]

  /** One or two places of a file are cut out, doubled or replaced, or a digit becomes another, by numbers of the seed. */
  function damaged(whole: string, seed: number): string {
    let state = seed * 2654435761 + 1
    const next = (below: number) => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0
      return Math.floor((state / 4294967296) * below)
    }
    let found = whole
    for (let times = 1 + next(2); times > 0; times--) {
      const at = next(found.length)
      const end = at + next(12)
      const digit = found.slice(at).search(/\d/)
      const put = [odd[next(odd.length)]!, '', found.slice(at, end).repeat(2), null][next(4)]
      if (put === null) found = found.slice(0, at + digit) + next(10) + found.slice(at + digit + 1)
      else found = found.slice(0, at) + put + found.slice(end)
    }
    return found
  }

  it(`${seeds.length} mutated files are opened or refused with one word`, () => {
    const counts = { opened: 0, refused: 0 }
    for (const seed of seeds) {
      const copy = damaged(text, seed)
      try {
        const read = fitExamples(parseExamplesFile(copy), net)
        expect(
          read.rows.every((row) => row.length === 10),
          copy,
        ).toBe(true)
        expect(
          read.rows.every(([drive]) => read.drives[drive!] !== undefined),
          copy,
        ).toBe(true)
        counts.opened++
      } catch (error) {
        expect(error, copy).toBeInstanceOf(ExamplesError)
        counts.refused++
      }
    }
    expect(counts.opened).toBeGreaterThan(seeds.length / 20)
    expect(counts.refused).toBeGreaterThan(seeds.length / 5)
  })
})
