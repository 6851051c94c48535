import fc from 'fast-check'
import { beforeEach, describe, expect, test } from 'vitest'
import { listBin, takeBack, throwAway } from './bin.ts'
import { database, type ProjectRecord } from './database.ts'
import { list, listWhole, load, open, rename, save } from './projects.ts'
import { rawText } from './handout.ts'
import { freshDevice } from './testing/device.ts'
import { fear, friendship, hash, withPicture } from './testing/sample.ts'

// Whatever one record holds, every other one is read, and the damaged one can be saved as it lies there.

beforeEach(freshDevice)

/** What a browser can keep: more than JSON. */
const anything = fc.oneof(
  { weight: 3, arbitrary: fc.jsonValue({ maxDepth: 3 }) },
  {
    weight: 2,
    arbitrary: fc.constantFrom<unknown>(
      ...[undefined, null, NaN, Infinity, -1, 0, '', 'x'.repeat(30_000), [], {}, true],
      ...[new Date(NaN), new Map([[1, 2]]), new Set([1]), 10n, /x/, new Uint8Array(3)],
    ),
  },
)

const paths = (value: unknown, path: readonly string[] = []): (readonly string[])[] =>
  typeof value === 'object' && value !== null && path.length < 5
    ? [path, ...Object.entries(value).flatMap(([key, one]) => paths(one, [...path, key]))]
    : [path]

function damagedAt(data: unknown, [key, ...rest]: readonly string[], value: unknown): unknown {
  if (key === undefined) return value
  const copy = (Array.isArray(data) ? [...(data as unknown[])] : { ...(data as object) }) as {
    [key: string]: unknown
  }
  copy[key] = damagedAt(copy[key], rest, value)
  return copy
}

/** Damage at any place of a record but its key. */
const damageIn = (record: object) =>
  fc
    .tuple(fc.constantFrom(...paths(record).filter(([key]) => key !== undefined && key !== 'id')), anything)
    .map(([path, value]) => damagedAt(record, path, value) as { id: string })

async function put(store: 'projects' | 'bin' | 'revisions' | 'pictures' | 'days', record: unknown) {
  await (await database()).put(store, record as never)
}

/** Every one of the others is there and whole. */
async function othersStand() {
  const { projects, damaged } = await list()
  expect(projects.find(({ id }) => id === 'fear')?.project).toEqual(fear)
  for (const one of damaged) expect(JSON.parse(rawText(one.raw))).not.toBeUndefined()
  expect((await listWhole()).projects.find(({ id }) => id === 'fear')?.project).toEqual(fear)
  expect((await load('fear'))?.project).toEqual(fear)
}

const record = (): ProjectRecord => ({
  ...{ id: 'friendship', changed: 1, pictures: [hash] },
  project: { ...withPicture(0), assets: {} },
})

describe('a damaged record', () => {
  test('of a project keeps no other out, and can be opened, renamed, thrown away and taken back without an error', async () => {
    await save('fear', fear, 0)
    await fc.assert(
      fc.asyncProperty(damageIn(record()), async (damaged) => {
        await put('projects', damaged)
        await othersStand()
        expect((await load('friendship'))?.id).toBe('friendship')
        await open('friendship')
        await rename('friendship', 'x')
        const moved = await throwAway('friendship')
        expect(moved.kind).toBe('moved')
        if (moved.kind === 'moved') expect((await takeBack(moved.id)).kind).toBe('moved')
        await othersStand()
      }),
      { numRuns: 150 },
    )
  })

  test('of a project of the version before neither', async () => {
    await save('fear', fear, 0)
    const old = { id: 'friendship', project: withPicture(10), changed: 1, revision: 5 }
    await fc.assert(
      fc.asyncProperty(damageIn(old), async (damaged) => {
        await (await database()).delete('revisions', 'friendship')
        await put('projects', damaged)
        await othersStand()
        expect((await load('friendship'))?.id).toBe('friendship')
        await othersStand()
      }),
      { numRuns: 150 },
    )
  })

  test('of a revision only asks which one goes on', async () => {
    await save('friendship', friendship, 0)
    await save('fear', fear, 0)
    await fc.assert(
      fc.asyncProperty(anything, async (revision) => {
        await put('revisions', { id: 'friendship', revision })
        const found = (await load('friendship'))!
        expect(found.project).toEqual(friendship)
        expect(Number.isSafeInteger(found.revision) && found.revision > 0).toBe(true)
        expect(await save('friendship', friendship, found.revision)).toMatchObject({ kind: 'saved' })
        await othersStand()
      }),
      { numRuns: 50 },
    )
  })

  test('of a picture leaves its project in the list, and all others whole', async () => {
    await save('fear', fear, 0)
    await save('friendship', withPicture(10), 0)
    await fc.assert(
      fc.asyncProperty(anything, async (asset) => {
        await put('pictures', { project: 'friendship', hash, asset })
        expect((await list()).projects.map(({ id }) => id).toSorted()).toEqual(['fear', 'friendship'])
        expect((await load('friendship'))?.id).toBe('friendship')
        await open('friendship')
        await othersStand()
      }),
      { numRuns: 50 },
    )
  })

  test('of the bin keeps no other of the bin out', async () => {
    await save('fear', fear, 0)
    await throwAway('fear')
    const old = { id: 'bin-x', was: 'friendship', project: friendship, changed: 1, revision: 5, thrown: 6 }
    await fc.assert(
      fc.asyncProperty(damageIn({ ...old, day: 1 }), async (damaged) => {
        await put('bin', damaged)
        const { thrown, damaged: unread } = await listBin()
        expect(thrown.find(({ was }) => was === 'fear')?.project).toEqual(fear)
        expect(thrown.length + unread.length).toBe(2)
        for (const { left } of thrown) expect(left >= 1 && left <= 30).toBe(true)
        for (const one of unread) JSON.parse(rawText(one.raw))
      }),
      { numRuns: 150 },
    )
  })

  test('of the days forgets nothing', async () => {
    await save('fear', fear, 0)
    await throwAway('fear')
    await fc.assert(
      fc.asyncProperty(anything, anything, async (count, last) => {
        await put('days', { id: 'used', count, last })
        expect((await listBin()).thrown.length).toBe(1)
      }),
      { numRuns: 50 },
    )
  })
})

describe('what lies in a record, as text', () => {
  test('is JSON, to the letter where it is data', () => {
    expect(rawText(friendship)).toBe(JSON.stringify(friendship))
    fc.assert(fc.property(anything, (value) => void JSON.parse(rawText(value))))
  })

  test('also where it is a circle, a large number, or deeper than JSON can write', () => {
    const round: { self?: unknown; name: string } = { name: 'Bo' }
    round.self = [round]
    expect(JSON.parse(rawText(round))).toEqual({ name: 'Bo', self: ['…'] })
    expect(JSON.parse(rawText({ a: 10n, twice: [friendship, friendship] }))).toEqual({
      ...{ a: '10', twice: [friendship, friendship] },
    })
    let deep: unknown = 'end'
    for (let depth = 0; depth < 100_000; depth += 1) deep = { deep }
    expect(rawText(deep).startsWith('{"deep":{"deep":')).toBe(true)
  })
})
