import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { promised } from '../../packages/browsers/promised.ts'
import { isOfInterest, pageOf, reportOf } from './report.ts'
import { entryAt, table } from './support.mjs'
import { Lookup, usesIn, type Use } from './uses.ts'

const house = mkdtempSync(join(tmpdir(), 'botgarten-uses-'))
afterAll(() => rmSync(house, { recursive: true, force: true }))

const lookup = new Lookup(table, (path) => entryAt(path)?.['__compat'] !== undefined)
const names = lookup.namesWhere((entry) => isOfInterest(entry, promised))

/** Scripts, each with the API that a promised browser lacks; null: none. */
const scripts: readonly (readonly [script: string, lacking: string | null])[] = [
  ['export const g = Map.groupBy([1], String)', 'MapConstructor.groupBy'],
  ['export const s = new URLSearchParams().size', 'URLSearchParams.size'],
  ['export const u = URL.canParse("a")', 'URL.canParse'],
  ['export const t = new Uint8Array(1).toBase64()', 'Uint8Array.toBase64'],
  ['export const i = new Intl.Segmenter()', 'Intl.Segmenter'],
  ['document.body.ariaLabel = "a"', 'ARIAMixin.ariaLabel'],
  ['requestIdleCallback(() => {})', 'requestIdleCallback'],
  ['export const n = new Set([1]).union(new Set([2]))', 'Set.union'],
  ['export const s = [2, 1].toSorted()', null],
  ['export const r = (a: Response) => a.json()', null],
  ['export const n = (a: NavigationPreloadManager) => a', null],
  ['export const mine = { groupBy: (a: string) => a }; mine.groupBy("a")', null],
  ['document.body.addEventListener("click", () => {})', null],
]
const none = { handled: {}, faults: {} }
const fileOf = (at: number) => `script${at}.ts`

let uses: readonly Use[]
beforeAll(() => {
  for (const [at, [script]] of scripts.entries())
    writeFileSync(join(house, fileOf(at)), `${script}\nexport {}\n`)
  const compilerOptions = { lib: ['esnext', 'dom'], types: [], noEmit: true, module: 'esnext' }
  const files = scripts.map((_, at) => fileOf(at))
  writeFileSync(join(house, 'tsconfig.json'), JSON.stringify({ compilerOptions, files }))
  uses = usesIn(join(house, 'tsconfig.json'), { isOurs: () => true, house, lookup, names })
})

test.each(scripts.map(([script, lacking], at) => [script, lacking, at] as const))(
  '%s: of its APIs a promised browser lacks %s',
  (_, lacking, at) => {
    const found = reportOf(uses, promised, none).lacking.filter(({ places }) => places.includes(fileOf(at)))
    expect(found.map(({ name }) => name)).toEqual(lacking === null ? [] : [lacking])
  },
)

test('an API says since when a browser has it, and in which files it is used', () => {
  const canParse = { name: 'URL.canParse', paths: ['api.URL.canParse_static'], places: [fileOf(2)] }
  expect(uses).toContainEqual(canParse)
  const [row] = reportOf([canParse], promised, none).lacking
  expect(row!.missing).toBe('safari before 17, safari_ios before 17, chrome before 120, edge before 120')
})

test('what is handled is on the page with its reason, and a reason for what no browser lacks is reported', () => {
  const some = uses.filter(({ name }) => /requestIdleCallback|toSorted/.test(name))
  const report = reportOf(some, promised, {
    handled: { requestIdleCallback: 'It comes later.' },
    faults: { 'Set.union': 'Not used.' },
  })
  expect(report.lacking).toEqual([])
  expect(report.unused).toEqual(['Set.union'])
  const page = pageOf(report, promised)
  expect(page).toContain('| `requestIdleCallback` | – | 55 | 47 | It comes later. |')
  expect(page).toContain('| `Array.toSorted` | 16 | 115 | 110 |')
})

test('without a configuration it says which command writes it', () => {
  expect(() => usesIn(join(house, 'none.json'), { isOurs: () => true, house, lookup, names })).toThrow(
    /types:web/,
  )
})
