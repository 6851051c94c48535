import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { compare, gone, likelyNew, toJson, uncounted, type Found } from './counts.ts'

const file = (path: string, phrases: number): Found => ({
  path,
  matches: Array.from({ length: phrases }, (_, line) => ({ rule: 'a', better: 'b', phrase: 'c', line })),
})

const worse = (...parameters: Parameters<typeof compare>) =>
  compare(...parameters).worse.map(({ path, allowed }) => [path, allowed])

describe('counts of phrases', () => {
  it('accept a file with as many phrases as before', () => {
    expect(compare({ 'a.ts': 2 }, [file('a.ts', 2)])).toEqual({ worse: [], better: [], next: { 'a.ts': 2 } })
  })

  it('refuse a file with one phrase more', () => {
    expect(worse({ 'a.ts': 2 }, [file('a.ts', 3)])).toEqual([['a.ts', 2]])
  })

  it('refuse any phrase in a new file', () => {
    expect(worse({ 'a.ts': 2 }, [file('a.ts', 2), file('b.ts', 1)])).toEqual([['b.ts', 0]])
  })

  it('fall with a file that has fewer phrases, and no longer list one that has none', () => {
    expect(compare({ 'a.ts': 2, 'b.ts': 1 }, [file('a.ts', 1), file('b.ts', 0)])).toEqual({
      worse: [],
      better: ['a.ts', 'b.ts'],
      next: { 'a.ts': 1 },
    })
  })

  it('forget a file that no longer exists', () => {
    expect(compare({ 'a.ts': 2 }, [])).toEqual({ worse: [], better: ['a.ts'], next: {} })
  })

  it('move with their file', () => {
    const origins = new Map([['b/a.ts', 'a.ts']])
    expect(compare({ 'a.ts': 2 }, [file('b/a.ts', 2)], origins)).toMatchObject({
      worse: [],
      next: { 'b/a.ts': 2 },
    })
    expect(worse({ 'a.ts': 2 }, [file('b/a.ts', 3)], origins)).toEqual([['b/a.ts', 2]])
  })

  it('name new files that have phrases, and counted files that no longer exist', () => {
    const found = [file('a.ts', 1), file('b.ts', 1), file('c.ts', 0)]
    expect(uncounted({ 'a.ts': 1, 'd.ts': 1 }, found)).toEqual(['b.ts'])
    expect(gone({ 'a.ts': 1, 'd.ts': 1 }, found)).toEqual(['d.ts'])
  })

  it('never rise unless a file is reported as worse', () => {
    const counts = fc.dictionary(fc.constantFrom('a.ts', 'b.ts', 'c.ts'), fc.integer({ min: 1, max: 4 }))
    fc.assert(
      fc.property(counts, counts, (before, now) => {
        const found = Object.entries(now).map(([path, count]) => file(path, count))
        const { worse: refused, next } = compare(before, found)
        const risen = Object.keys(next).filter((path) => next[path]! > (before[path] ?? 0))
        expect(refused.map(({ path }) => path).sort()).toEqual(risen)
      }),
    )
  })

  it('are saved in the order of their paths', () => {
    const { next } = compare({}, [file('b.ts', 1), file('a.ts', 2), file('B.ts', 3)])
    expect(toJson(next)).toBe('{\n  "B.ts": 3,\n  "a.ts": 2,\n  "b.ts": 1\n}\n')
  })
})

describe('the phrases that are reported for a file', () => {
  const { matches } = file('a.ts', 3)
  const at = (text: string, before?: string) =>
    likelyNew(
      matches.map((match, index) => ({ ...match, line: index + 1 })),
      text,
      before,
    ).map(({ line }) => line)

  it('are those on new lines', () => {
    expect(at('// one\n// two\n// three', '// three\n// one')).toEqual([2])
  })

  it('are all of them if no line is new, or the file is', () => {
    expect(at('// one\n// two\n// three', '// one\n// two\n// three')).toEqual([1, 2, 3])
    expect(at('// one\n// two\n// three')).toEqual([1, 2, 3])
  })
})
