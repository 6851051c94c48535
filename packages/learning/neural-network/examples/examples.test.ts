import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { starter } from '../train/settings.ts'
import { step } from '../train/step.ts'
import {
  beginExercise,
  columnsFor,
  findingsIn,
  mostOf,
  noExamples,
  prepare,
  shownPairs,
  withDrive,
  withoutGaps,
} from './index.ts'
import { splitDrives } from './split.ts'
import type { Drive, Exercise, Recorded, ShownPair, Table } from './index.ts'

const pose = { x: 1.005, y: 2, heading: -0.001 }
const drive = (id: string, more: Partial<Drive> = {}): Drive => ({ id, by: 'pad', seed: 1, ...more })
const shown = (inputs: readonly number[], outputs: readonly number[], tick = 6): Recorded => ({
  ...{ tick, pose, inputs, outputs },
})
const empty = noExamples(['l', 'r'], ['m', 'n'])

describe('a table of examples', () => {
  it('takes a drive up with two decimals; a row that says the same again is not written', () => {
    const rows = [shown([40.004, 90], [10, 60]), shown([40.9, 90], [10, 60.5]), shown([42, 90], [10, 60])]
    const { examples, left } = withDrive(empty, drive('first'), rows)
    expect(left).toBe(0)
    expect(examples.rows).toEqual([
      [0, 6, 1, 2, 0, 1, 40, 90, 10, 60],
      [0, 6, 1, 2, 0, 1, 42, 90, 10, 60],
    ])
  })

  it('stops at its limits and says how many are left out; nothing is overwritten', () => {
    const many = Array.from({ length: mostOf.rows + 7 }, (_, k) =>
      shown([(k * 3) % 101, 0], [k % 50, (k * 7) % 90]),
    )
    const full = withDrive(empty, drive('long'), many)
    expect([full.examples.rows.length, full.left]).toEqual([mostOf.rows, 7])
    const drives = Array.from({ length: mostOf.drives }, (_, k) => drive(`${k}`))
    const all = { ...empty, drives }
    expect(withDrive(all, drive('more'), many)).toEqual({ examples: all, left: -1 })
  })

  it('fills its gaps with 0, and is the same table where it has none', () => {
    const { examples } = withDrive(empty, drive('first'), [shown([40, 90], [10, 60])])
    const wider = columnsFor(examples, ['l', 'r', 'new'], ['m', 'n'])
    expect(withoutGaps(wider).rows).toEqual([[0, 6, 1, 2, 0, 1, 40, 90, 0, 10, 60]])
    expect(withoutGaps(examples)).toBe(examples)
  })

  it('practises what is on and whole; a neuron that is new has gaps, one that is gone is not asked', () => {
    const { examples } = withDrive(empty, drive('first'), [shown([1, 2], [3, 4]), shown([50, 60], [70, 80])])
    const rows = examples.rows.map((row, at) => (at === 0 ? row.with(5, 0) : row))
    expect(shownPairs({ ...examples, rows }, ['r', 'l'], ['n'])).toEqual({
      pairs: [{ row: 1, drive: 0, inputs: [60, 50], outputs: [80] }],
      gaps: 0,
    })
    expect(shownPairs(examples, ['l', 'new'], ['m'])).toEqual({ pairs: [], gaps: 2 })
    expect(
      shownPairs({ ...examples, rows: examples.rows.map((row) => row.with(7, null)) }, ['r'], ['m']).gaps,
    ).toBe(2)
  })
})

describe('what is held back', () => {
  const pairsOf = (drives: number, rows: number): ShownPair[] =>
    Array.from({ length: drives * rows }, (_, k) => ({
      row: k,
      drive: k % drives,
      inputs: [k],
      outputs: [k],
    }))
  const drivesOf = (count: number) => Array.from({ length: count }, (_, k) => drive(`drive ${k}`))
  const heldIn = (count: number, seed: number) => {
    const { kept } = splitDrives(pairsOf(count, 10), drivesOf(count), seed, 0.2)
    return new Set(kept.map((pair) => pair.drive))
  }

  it('are whole drives, about a fifth of them', () => {
    const shares = Array.from({ length: 40 }, (_, seed) => heldIn(50, seed).size / 50)
    expect(shares.reduce((a, b) => a + b) / 40).toBeCloseTo(0.2, 1)
  })

  it('does not change when a drive is added', () => {
    fc.assert(
      fc.property(fc.nat(), fc.integer({ min: 10, max: 60 }), (seed, count) => {
        const [before, after] = [heldIn(count, seed), heldIn(count + 1, seed)]
        fc.pre(before.size > 0 && after.size > 0)
        expect([...after].filter((at) => at < count).sort()).toEqual([...before].sort())
      }),
      { seed: 3 },
    )
  })

  it('is nothing of few examples or one drive; where the draw takes none or all, it asks', () => {
    const all = { kept: [], asks: false }
    expect(splitDrives(pairsOf(3, 3), drivesOf(3), 1, 0.2)).toMatchObject(all)
    expect(splitDrives(pairsOf(1, 30), drivesOf(1), 1, 0.2)).toMatchObject(all)
    expect(splitDrives(pairsOf(3, 30), drivesOf(3), 1, 0)).toMatchObject(all)
    expect(splitDrives(pairsOf(3, 30), drivesOf(3), 1, 1e-9)).toMatchObject({ kept: [], asks: true })
    expect(splitDrives(pairsOf(3, 30), drivesOf(3), 1, 1)).toMatchObject({ kept: [], asks: true })
  })

  it('is what was chosen by hand, before any draw', () => {
    const drives = [drive('a', { test: true }), drive('b', { test: false }), drive('c', { test: false })]
    const { kept } = splitDrives(pairsOf(3, 10), drives, 1, 1e-9)
    expect(new Set(kept.map((pair) => pair.drive))).toEqual(new Set([0]))
  })
})

describe('an exercise', () => {
  const neuron = (id: string) => ({ id, activation: 'identity' as const, bias: 0 })
  const { examples } = withDrive(empty, drive('first'), [
    shown([80, 20], [10, 60]),
    shown([20, 80], [60, 10]),
  ])
  const exercise: Exercise = {
    ...{ id: 'net', layers: [['l', 'r'].map(neuron), ['m', 'n'].map(neuron)], weights: {}, examples },
    ...{ seed: 1, keepBack: 0.2, from: 'knobs', mirror: null },
  }

  it('practises both rows, and with a mirror four', () => {
    expect(prepare(exercise).data.practised.count).toBe(2)
    expect(prepare({ ...exercise, mirror: { inputs: [1, 0], outputs: [1, 0] } }).data.practised.count).toBe(4)
  })

  it('whose rows are set aside and put back ends with equal bits', () => {
    const after = (rows: (typeof examples)['rows']) => {
      const given = { ...exercise, examples: { ...examples, rows } }
      const practice = beginExercise(prepare(given), starter, given)
      while (practice.ended === null) step(practice)
      return practice.parameters
    }
    const aside = examples.rows.map((row) => row.with(5, 0))
    expect(after(aside.map((row) => row.with(5, 1)))).toEqual(after(examples.rows))
    expect(() => after(aside)).toThrow('no examples')
  })
})

describe('questions about examples', () => {
  const table = (
    rows: readonly (readonly [number, number, number, number])[],
    more: Partial<Table> = {},
  ): Table => ({
    pairs: rows.map(([l, r, m, n], row) => ({ row, drive: 0, inputs: [l, r], outputs: [m, n] })),
    ...{ inputs: ['l', 'r'], outputs: ['m', 'n'], wheels: { left: 0, right: 1 }, mirror: null, knobs: 0 },
    ...more,
  })
  /** Turns away from the nearer side, as wide as the eyes differ. */
  const good = Array.from({ length: 24 }, (_, k): [number, number, number, number] => {
    const [l, r] = [(k * 37) % 101, (k * 61) % 101]
    return [l, r, r / 2 + 10, l / 2 + 10]
  })
  const kindsIn = (given: Table) => findingsIn(given).map(({ kind }) => kind)

  it('are none where the examples are good', () => {
    expect(findingsIn(table(good))).toEqual([])
  })

  it('a contradiction names the row that fits fewest others, and these', () => {
    const rows: [number, number, number, number][] = [
      ...good.slice(0, 3),
      ...(
        [
          [50, 20, 80, 80],
          [52, 21, -60, 10],
          [51, 19, 79, 82],
        ] as const
      ).map(([...row]): [number, number, number, number] => row),
    ]
    expect(findingsIn(table(rows))[0]).toEqual({ kind: 'contradiction', row: 4, others: [3, 5] })
  })

  it('blind: nothing is seen, and different things were wished', () => {
    expect(
      findingsIn(table([...good.slice(0, 9), [100, 100, 90, -90], [100, 100, -90, 90]]))[0],
    ).toMatchObject({
      kind: 'blind',
      others: [10],
    })
    expect(kindsIn(table([...good.slice(1, 9), [0, 0, 90, -90], [0, 0, -90, 90]]))).toContain('blind')
  })

  it('an odd one is far from what its four nearest wish', () => {
    const rows = [10, 30, 50, 70, 90].map((at): [number, number, number, number] => [
      at,
      at,
      50 + at / 10,
      20,
    ])
    expect(findingsIn(table([...rows, [60, 60, -50, 20]], { wheels: null }))[0]).toEqual({
      kind: 'oddOne',
      row: 5,
    })
  })

  it('an odd one may also be what practice cannot learn', () => {
    const errors = good.map((_, row) => (row === 4 ? 1 : 0.01))
    expect(findingsIn(table(good, { errors }))).toEqual([{ kind: 'oddOne', row: 4 }])
    expect(findingsIn(table(good, { errors: good.map(() => 0.01) }))).toEqual([])
  })

  it('one-sided: more than three turns to one side for one to the other, unless a mirror makes up for it', () => {
    const left = Array.from({ length: 40 }, (_, k): [number, number, number, number] => [k, 2 * k, 20, 60])
    const right = Array.from({ length: 6 }, (_, k): [number, number, number, number] => [
      100,
      60 + k * 3,
      60,
      30,
    ])
    expect(findingsIn(table([...left, ...right]))).toContainEqual({ kind: 'oneSided', left: 40, right: 6 })
    const mirror = { inputs: [1, 0], outputs: [1, 0] }
    expect(kindsIn(table([...left, ...right], { mirror }))).not.toContain('oneSided')
    expect(kindsIn(table([...left, ...right], { wheels: null }))).not.toContain('oneSided')
  })

  it('one-sided: wheels that differ by 5 percent do not turn', () => {
    const rows = (count: number, right: number) =>
      Array.from({ length: count }, (_, k) => [k, k, 50, 50 + right] as const)
    const leftOnly = table([...rows(5, 6), ...rows(5, -5)])
    const rightOnly = table([...rows(5, -6), ...rows(5, 5)])
    expect(findingsIn(leftOnly)).toContainEqual({ kind: 'oneSided', left: 5, right: 0 })
    expect(findingsIn(rightOnly)).toContainEqual({ kind: 'oneSided', left: 0, right: 5 })
  })

  it('never seen: no example is near to where the last drive failed', () => {
    const far = table(
      good.filter(([l, r]) => l > 40 || r > 40),
      {
        failed: [
          [5, 5],
          [90, 50],
        ],
      },
    )
    expect(findingsIn(far)).toEqual([{ kind: 'neverSeen', readings: [5, 5] }])
  })

  it('all alike: a column that hardly spreads', () => {
    const rows = good.map(([l, r, m]): [number, number, number, number] => [l, r, m, 60])
    expect(findingsIn(table(rows, { wheels: null }))).toEqual([
      { kind: 'allAlike', column: 'n', isInput: false, value: 60 },
    ])
  })

  it('sleeping: more than half of the examples say stand', () => {
    const asleep = good.map(([l, r]): [number, number, number, number] => [l, r, 0, 0])
    const found = findingsIn(table([...good.slice(0, 10), ...asleep.slice(10)], { wheels: null }))
    expect(found.find(({ kind }) => kind === 'sleeping')).toMatchObject({
      rows: expect.arrayContaining([10, 23]) as number[],
    })
    expect(kindsIn(table([...good.slice(0, 14), ...asleep.slice(14)]))).not.toContain('sleeping')
  })

  it('few: less than two examples for every knob, mirror images counted', () => {
    const three = good.slice(1, 4)
    expect(findingsIn(table(three, { knobs: 4 }))).toContainEqual({
      ...{ kind: 'few', rows: 3, isMirrored: false, knobs: 4 },
    })
    const mirror = { inputs: [1, 0], outputs: [1, 0] }
    expect(findingsIn(table(three, { knobs: 4, mirror }))).toContainEqual({
      ...{ kind: 'few', rows: 3, isMirrored: true, knobs: 4 },
    })
    expect(kindsIn(table(good.slice(1, 5), { knobs: 4, mirror }))).not.toContain('few')
  })

  it('name each row once and change nothing', () => {
    const cell = fc.integer({ min: -100, max: 100 })
    fc.assert(
      fc.property(fc.array(fc.tuple(cell, cell, cell, cell), { maxLength: 40 }), (rows) => {
        const given = table(rows, { knobs: 4 })
        const before = JSON.stringify(given)
        const named = findingsIn(given).flatMap((finding) => ('row' in finding ? [finding.row] : []))
        expect(new Set(named).size).toBe(named.length)
        expect(JSON.stringify(given)).toBe(before)
      }),
      { seed: 11 },
    )
  })
})
