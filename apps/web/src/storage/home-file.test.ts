import { ProjectError, type Project } from '@botgarten/programs'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import type { Binned } from './bin.ts'
import { packHome, readHome, mergeBin, mergeHome } from './home-file.ts'
import type { Listed } from './projects.ts'
import { fear, friendship } from './testing/sample.ts'

const moved = (project: Project, hints: number): Project => ({ ...project, progress: { starts: [], hints } })
const kept = (id: string, project: Project, changed = 1): Listed => ({ id, project, changed })

const day = 86_400_000
const now = Date.UTC(2026, 10, 21)
const writeHome = (all: readonly Listed[], bin: readonly Binned[] = []) =>
  packHome(all, bin, { sound: false })[0]!
/** Something that has been in the bin for so many days of use. */
const thrown = (was: string, project: Project, days: number): Binned => ({
  ...{ id: `bin-${was}`, was, project, changed: 1 },
  ...{ thrown: now - days * day, left: 30 - days },
})

let fresh = 0
const names = {
  fresh: (place: string) => `${place}-fresh${fresh++}`,
  copy: ({ name }: Project) => `${name} (copy)`,
  place: (project: Project) => project.card ?? 'free',
}
const merge = (here: readonly Listed[], file: string, keys: readonly string[] = []) =>
  mergeHome(here, keys, readHome(JSON.parse(file)).projects, names)

test('what was taken home is there again on an empty device, under its keys', () => {
  const all = [kept('friendship', friendship), kept('fear-x1', fear, 99)]
  const { added, same, copies } = merge([], writeHome(all))
  expect(added).toEqual(all)
  expect([same, copies]).toEqual([0, 0])
})

test('what is here already is not doubled, whatever its key and its name', () => {
  const here = [kept('friendship-other', { ...friendship, name: 'Mine' })]
  const { added, same } = merge(here, writeHome([kept('friendship', friendship)]))
  expect([added.length, same]).toEqual([0, 1])
})

test('another project of the same key is not overwritten: the one from the file becomes a copy', () => {
  const here = [kept('friendship', friendship)]
  const { added, copies } = merge(here, writeHome([kept('friendship', moved(friendship, 3))]))
  expect(copies).toBe(1)
  expect(added[0]!.id).toMatch(/^friendship-fresh/)
  expect(added[0]!.project.name).toBe('friendship (copy)')
})

test('opening the same file once more adds nothing', () => {
  const here = [kept('friendship', friendship)]
  const file = writeHome([kept('friendship', moved(friendship, 3)), kept('fear', fear)])
  const after = [...here, ...merge(here, file).added]
  expect(merge(after, file).added).toEqual([])
})

test('a key of a project that cannot be read is not taken either', () => {
  const { added, copies } = merge([], writeHome([kept('friendship', friendship)]), ['friendship'])
  expect([added[0]!.id.startsWith('friendship-fresh'), copies]).toEqual([true, 1])
})

test('a key that belongs to another card is not taken over', () => {
  const { added } = merge([], writeHome([kept('friendship', fear)]))
  expect(added[0]!.id).toMatch(/^fear-fresh/)
})

test('whatever the keys are, nothing here loses its own and no two get the same', () => {
  const key = fc.constantFrom('friendship', 'friendship-a', 'friendship-b', 'fear', 'fear-a')
  const project = fc
    .tuple(fc.constantFrom(friendship, fear), fc.nat(5))
    .map(([one, hints]) => moved(one, hints))
  const list = fc.uniqueArray(fc.tuple(key, project), { selector: ([id]) => id })
  fc.assert(
    fc.property(list, list, (mine, theirs) => {
      const here = mine.map(([id, one]) => kept(id, one))
      const { added } = merge(here, writeHome(theirs.map(([id, one]) => kept(id, one))))
      const ids = [...here, ...added].map(({ id }) => id)
      expect(new Set(ids).size).toBe(ids.length)
      // Everything of the file is somewhere now, to the letter.
      const all = [...here, ...added].map(({ project: { name: _, ...rest } }) => JSON.stringify(rest))
      for (const [, { name: _, ...rest }] of theirs) expect(all).toContain(JSON.stringify(rest))
    }),
  )
})

test('one broken project does not keep the others out', () => {
  const file = JSON.parse(writeHome([kept('friendship', friendship)])) as { projects: unknown[] }
  file.projects.push({ id: 'x', changed: 1, project: { botgarten: 1 } }, null, { id: '../x' })
  const { projects, broken } = readHome(file)
  expect(projects.map(({ id }) => id)).toEqual(['friendship'])
  expect(broken).toBe(3)
})

test('whatever a home file holds, the answer is what could be read or a reason', () => {
  const data = fc.oneof(
    fc.jsonValue(),
    fc.record({ botgartenHome: fc.constant(1), projects: fc.array(fc.jsonValue()) }),
    fc.record({
      botgartenHome: fc.constant(2),
      projects: fc.array(fc.jsonValue()),
      bin: fc.array(fc.jsonValue()),
      settings: fc.jsonValue(),
    }),
  )
  fc.assert(
    fc.property(data, (foreign) => {
      try {
        const { projects, bin } = readHome(foreign)
        expect([projects, bin]).toEqual([[], []])
      } catch (cause) {
        if (!(cause instanceof ProjectError)) throw cause
      }
    }),
  )
})

test('a home file of a later version says so', () => {
  expect(() => readHome({ botgartenHome: 3, projects: [] })).toThrow(
    expect.objectContaining({ reason: 'newerVersion' }),
  )
})

test('a file of the first version had projects only, and is still read', () => {
  const { projects } = JSON.parse(writeHome([kept('friendship', friendship)])) as { projects: unknown }
  const read = readHome({ botgartenHome: 1, projects })
  expect(read.projects.map(({ id }) => id)).toEqual(['friendship'])
  expect([read.bin, read.settings, read.broken]).toEqual([[], {}, 0])
})

describe('the bin', () => {
  const file = writeHome([], [thrown('friendship', friendship, 12), thrown('fear', fear, 0)])
  const { bin, settings } = readHome(JSON.parse(file))

  test('goes home too, with the settings, and its 30 days go on where they stopped', () => {
    const muchLater = now + 400 * day
    expect(mergeBin([], bin, muchLater)).toEqual([
      { was: 'friendship', project: friendship, changed: 1, thrown: muchLater - 12 * day, daysIn: 12 },
      { was: 'fear', project: fear, changed: 1, thrown: muchLater, daysIn: 0 },
    ])
    expect(settings).toEqual({ sound: false })
  })

  test('what lies in the bin here is not doubled, and the same file adds nothing twice', () => {
    const here = mergeBin([], bin, now)
    expect(mergeBin(here, bin, now)).toEqual([])
    expect(mergeBin([], [...bin, ...bin], now)).toHaveLength(2)
    // Two versions of one project are two.
    expect(mergeBin([thrown('friendship', moved(friendship, 3), 1)], bin, now)).toHaveLength(2)
  })

  test.each([
    ['an age that is no number', { age: 'x' }],
    ['an age below nothing', { age: -1 }],
    ['no key', { was: '' }],
    ['a key as long as a book', { was: 'x'.repeat(301) }],
    ['a broken project', { project: { botgarten: 1 } }],
  ])('%s is left out and counted, the rest stays', (_, wrong) => {
    const data = JSON.parse(file) as { bin: object[] }
    data.bin[0] = { ...data.bin[0], ...wrong }
    const read = readHome(data)
    expect([read.bin.map(({ was }) => was), read.broken]).toEqual([['fear'], 1])
  })

  test('an age beyond all bounds is that of the last day', () => {
    const old = { ...bin[0]!, age: 8e15 }
    expect(mergeBin([], [old], now)[0]!.daysIn).toBe(29)
  })
})

describe('more than one file may hold', () => {
  const all = Array.from({ length: 7 }, (_, k) => kept(`friendship-${k}`, moved(friendship, k), k))
  const bin = [thrown('a', fear, 3), thrown('b', moved(fear, 2), 29)]
  const settings = { sound: false, tour: 'seen' }
  const texts = (bytes: number, projects = 100) => packHome(all, bin, settings, { bytes, projects })

  test('is one file to the last byte that fits', () => {
    const [whole] = packHome(all, bin, settings)
    const length = new TextEncoder().encode(whole).length
    expect(texts(length)).toEqual([whole])
    expect(texts(length - 1).length).toBe(2)
  })

  test('goes into several, none larger than it may be, that are the whole together in any order', () => {
    for (const most of [5000, 8000, 12_000]) {
      const files = texts(most)
      expect(files.length).toBeGreaterThan(1)
      for (const text of files) expect(new TextEncoder().encode(text).length).toBeLessThanOrEqual(most)
      let here: readonly Listed[] = []
      let binned: ReturnType<typeof mergeBin> = []
      for (const text of files.toReversed()) {
        const read = readHome(JSON.parse(text))
        expect(read.broken).toBe(0)
        here = [...here, ...mergeHome(here, [], read.projects, names).added]
        binned = [...binned, ...mergeBin(binned, read.bin, now)]
      }
      expect(here.toSorted((a, b) => a.changed - b.changed)).toEqual(all)
      expect(binned.map(({ was, daysIn }) => [was, daysIn]).toSorted()).toEqual([['a', 3], ['b', 29]]) // prettier-ignore
    }
  })

  test('is parted by number too, and the settings are in the first', () => {
    const files = texts(1e8, 3)
    expect(files.map((text) => readHome(JSON.parse(text)).projects.length)).toEqual([3, 3, 1])
    expect(files.map((text) => readHome(JSON.parse(text)).settings)).toEqual([settings, {}, {}])
  })

  test('2,000 projects are one file, one more are two', () => {
    const many = (count: number) => Array.from({ length: count }, (_, k) => kept(`free-${k}`, fear))
    expect(packHome(many(2000), [], {}).length).toBe(1)
    expect(packHome(many(2001), [], {}).length).toBe(2)
  })

  test('a key that is longer than any reader takes comes back all the same', () => {
    const [text] = packHome([kept('k'.repeat(400), friendship), kept('', fear)], [], {})
    const { projects, broken } = readHome(JSON.parse(text!))
    expect([broken, projects.map(({ project }) => project)]).toEqual([0, [friendship, fear]])
  })
})
