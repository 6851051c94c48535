import fc from 'fast-check'
import { expect, test } from 'vitest'
import {
  arrangementOf,
  bordersOf,
  byKey,
  gap,
  gridOf,
  gridOfTwo,
  moved,
  nextPane,
  scrollsAsPage,
} from './arrangement.ts'

test('visual.md 3: the width of the window decides the arrangement, a low one shows pages', () => {
  const at = (width: number, height = 768) => arrangementOf({ width, height })
  expect([at(1366), at(1280)]).toEqual(['columns', 'columns'])
  expect([at(1279), at(1024), at(1000)]).toEqual(['stacked', 'stacked', 'stacked'])
  expect([at(999), at(640)]).toEqual(['rows', 'rows'])
  expect([at(639), at(390, 844), at(683, 384)]).toEqual(['pages', 'pages', 'pages'])
})

test('visual.md 3: at 1366 × 768 the panes are 452, 396 and the rest', () => {
  const [program, world] = bordersOf('columns', { width: 1346, height: 630 }, {})
  expect([program?.at, world?.at]).toEqual([452, 396])
})

test('code has more room than the world, and stands beside its blocks', () => {
  const borders = bordersOf('columns', { width: 1346, height: 630 }, {}, 'code')
  const [program, code] = borders.map(({ at }) => at)
  // The longest line of most files, 64 letters at 13.5 px, and a world whose bar has the word Start.
  expect(code).toBeGreaterThanOrEqual(550)
  expect(1346 - 2 * gap - program! - code!).toBeGreaterThanOrEqual(360)
  expect(gridOf('columns', borders, 'code')).toMatch(/^"program first network second world"/)
})

test('visual.md 3: at 1024 × 768 the program is 458 wide and the world 274 high', () => {
  const [program, world] = bordersOf('stacked', { width: 1004, height: 630 }, {})
  expect([program?.at, world?.at]).toEqual([458, 274])
})

test('visual.md 3: on large screens the world grows first and the program is at most 560', () => {
  const at = (width: number) => bordersOf('columns', { width, height: 900 }, {}).map((border) => border.at)
  const network = (width: number) => width - 2 * gap - (at(width)[0] ?? 0) - (at(width)[1] ?? 0)
  expect(network(1580)).toBe(482)
  expect(at(1900)).toEqual([560, 760])
  expect(network(1900)).toBeGreaterThan(482)
})

const shares = fc.tuple(
  fc.double({ min: 0, max: 1, noNaN: true }),
  fc.double({ min: 0, max: 1, noNaN: true }),
)

test('visual.md 3: wherever a border is dragged, program 340, world 300 and network 340 remain', () => {
  fc.assert(
    fc.property(fc.integer({ min: 1260, max: 3000 }), shares, (width, columns) => {
      const [program, world] = bordersOf('columns', { width, height: 630 }, { columns })
      const network = width - 2 * gap - program!.at - world!.at
      expect(program!.at).toBeGreaterThanOrEqual(340)
      expect(world!.at).toBeGreaterThanOrEqual(300)
      expect(network).toBeGreaterThanOrEqual(339)
    }),
  )
})

test('a border that was moved stands where it was put, and the other one stays', () => {
  const area = { width: 1346, height: 630 }
  const before = bordersOf('columns', area, {})
  const after = bordersOf('columns', area, moved('columns', area, before, 1, 420))
  expect(after.map((border) => border.at)).toEqual([452, 420])
})

test('without a network the world has its place too, beside or above the program', () => {
  const area = { width: 1346, height: 630 }
  const grid = (arrangement: 'columns' | 'stacked' | 'rows') =>
    gridOfTwo(arrangement, bordersOf(arrangement, area, {}))
  expect(grid('columns')).toBe('"program first world" minmax(0, 1fr) / 452px 8px minmax(0, 1fr)')
  expect(grid('stacked')).toMatch(/^"program first world" minmax\(0, 1fr\)/)
  expect(grid('rows')).toMatch(/^"world" 315px "first" 8px "program"/)
})

test('at 400 % zoom the lab scrolls as a page; a phone and a laptop at 200 % keep it in the window', () => {
  const at = (width: number, height: number) => scrollsAsPage({ width, height })
  expect([at(342, 192), at(320, 256)]).toEqual([true, true])
  expect([at(390, 844), at(844, 390), at(683, 384), at(1366, 768)]).toEqual([false, false, false, false])
})

test('F6 goes round the panes, Shift and F6 the other way, from outside to the first or the last', () => {
  const panes = ['program', 'world', 'network'] as const
  expect([null, ...panes].map((here) => nextPane(panes, here, false))).toEqual([
    ...['program', 'world', 'network', 'program'],
  ])
  expect([null, ...panes].map((here) => nextPane(panes, here, true))).toEqual([
    ...['network', 'network', 'program', 'world'],
  ])
})

test('keys move a border along its axis, in small or large steps, or to its ends; other keys do not', () => {
  const border = { axis: 'x', at: 400, min: 340, max: 700 } as const
  expect([byKey(border, 'ArrowLeft', false), byKey(border, 'ArrowRight', true)]).toEqual([384, 464])
  expect([byKey(border, 'Home', false), byKey(border, 'End', false)]).toEqual([340, 700])
  expect(byKey(border, 'ArrowUp', false)).toBeUndefined()
  expect(byKey({ ...border, axis: 'y' }, 'ArrowUp', false)).toBe(384)
})
