import { globSync, readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { inHouse } from '../prepare/house.mjs'
import { isReadable, mutantsOf } from './mutations.ts'
import equivalents from './equivalent.json' with { type: 'json' }
import { isSame, sampleOf } from './sample.ts'
import { roomsIn } from './rooms.ts'

const changesIn = (source: string) => mutantsOf('a.ts', source).map(({ change }) => change)

test.each([
  ['if (a) go()', ['a → !(a)', 'go() → nothing']],
  ['if (a === 1) go()', ['=== → !==', '1 → 2', 'go() → nothing']],
  ['const b = a < 1 ? -a : true', ['a < 1 → !(a < 1)', '< → <=', '1 → 2', '-a → a', 'true → false']],
  ['const b = a?.c ?? "x"', ['?. → .', '?? → &&', '"x" → \'\'']],
  ['const b = a?.[0]', ['?. → ', '0 → 1']],
  ["const b = { 'x': '' }", ["'' → 'mutant'"]],
  ['while (!a) a += 1', ['!a → a', 'a += 1 → nothing', '+= → -=', '1 → 2']],
  ['const f = (): void => { go() }', ['{ go() } → {}', 'go() → nothing']],
  ['const f = () => { return go() }', []],
  ['for (let a = 0; a < b; a++) {}', ['0 → 1', '< → <=', 'a++ → a--']],
  ['const b = Math.min(a.every(go))', ['min → max', 'every → some']],
  ["a = a + 'x' + 'x'", ["a = a + 'x' + 'x' → nothing", '+ → -', "'x' → ''", '+ → - (2)', "'x' → '' (2)"]],
])('%s has these faults', (source, changes) => {
  expect(changesIn(source).toSorted()).toEqual(changes.toSorted())
})

test.each([
  "import a from 'b'",
  "export { a } from 'b'",
  'interface A { b: 1; c: "x" }',
  'type A = "x" | 1',
  "throw new RangeError('not that')",
  "console.warn('here')",
  'class A extends B { constructor() { super(b) } }',
])('%s has none: it is no code that does something', (source) => {
  expect(changesIn(source)).toEqual([])
})

test('every fault changes one place of the file, and is named by its line', () => {
  const files = globSync('packages/learning/**/*.ts', { cwd: inHouse('.') })
  for (const file of files) {
    const source = readFileSync(inHouse(file), 'utf8')
    const names = new Set<string>()
    for (const { text, line, was, change } of mutantsOf(file, source)) {
      expect(text).not.toBe(source)
      expect(source.split('\n')[line - 1]!.trim().replace(/\s+/g, ' ').slice(0, 80)).toBe(was)
      names.add(`${line} ${change}`)
    }
    expect(names.size).toBe(mutantsOf(file, source).length)
  }
  expect(files.length).toBeGreaterThan(20)
})

test('what cannot be read is no fault that a test has to find', () => {
  const mutant = (text: string) => ({ file: 'a.ts', line: 1, was: '', change: '', text })
  expect(isReadable(mutant('const a = b && c'))).toBe(true)
  expect(isReadable(mutant('const a = b +'))).toBe(false)
})

test('the same seed is the same sample, another one another; equivalent ones are left out', () => {
  const house = inHouse('.')
  const room = roomsIn(house).find(({ name }) => name === 'web/storage')!
  const draw = (seed: number) => sampleOf(house, room, { count: 20, seed, equivalent: [] }).mutants
  const drawn = draw(1)
  expect(draw(1)).toEqual(drawn)
  expect(draw(2)).not.toEqual(drawn)
  expect(drawn).toHaveLength(20)
  const [first, ...others] = drawn
  const equivalent = [{ ...first!, because: 'It does the same.' }]
  expect(sampleOf(house, room, { count: 19, seed: 1, equivalent }).mutants).toEqual(others)
})

test('what is listed as equivalent is there, and says why', () => {
  for (const one of equivalents) {
    const source = readFileSync(inHouse(one.file), 'utf8')
    expect(mutantsOf(one.file, source).filter((mutant) => isSame(mutant, one))).toHaveLength(1)
    expect(one.because).toMatch(/\w.*\.$/)
  }
})
