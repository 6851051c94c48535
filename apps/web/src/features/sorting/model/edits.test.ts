import { isLong } from '@botgarten/numbers/testing'
import fc from 'fast-check'
import { afterEach, beforeEach, test, vi } from 'vitest'
import { sets } from '#figures/things/sets.ts'
import { load, save } from '#storage/projects.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { friendship } from '#storage/testing/sample.ts'
import { Playground } from './playground.svelte.ts'
import { SortingProject } from './store.svelte.ts'
import { traps } from './traps.ts'
import { OWN_TABLE } from './work.ts'

beforeEach(async () => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'setInterval', 'clearInterval'] })
  await freshDevice()
})
afterEach(() => void vi.useRealTimers())

/** `BOTGARTEN_EDITS=<number>` runs another number of sequences. */
const sequences = Number(process.env['BOTGARTEN_EDITS'] ?? (isLong ? 10_000 : 150))
/** `BOTGARTEN_EDITS_COUNT=1` counts the sequences that fail instead of ending with the first. */
const counts = process.env['BOTGARTEN_EDITS_COUNT'] === '1'

/** A playground on a project that the device has. */
async function opened(
  id: string,
): Promise<{ readonly playground: Playground; readonly store: SortingProject }> {
  const kept = await load(id)
  const store = new SortingProject({ id, revision: kept!.revision, project: kept!.project })
  return { playground: new Playground(store), store }
}

/** Every kind of edit; `a`, `b`: numbers from 0 to below 1. */
const edits: { readonly [kind: string]: (playground: Playground, a: number, b: number) => void } = {
  things: (playground, a) => playground.takeSet(sets[Math.floor(a * sets.length)]!.id),
  trap: (playground, a) =>
    playground.takeTrap(Object.keys(traps)[Math.floor(a * Object.keys(traps).length)]!),
  own: (playground) => playground.takeOwn(),
  table: (playground) => playground.hasTable && playground.takeOwnTable(),
  file: (playground, a, b) =>
    playground.takeTable(
      ['x', 'y'],
      [
        [a, b],
        [b, a],
        [1, 2],
      ],
    ),
  source: (playground, a) =>
    playground.turnTo((['things', 'points', 'readings'] as const)[Math.floor(a * 3)]!),
  point: (playground, a, b) => playground.work.source === 'points' && playground.addPoint(a * 10, b * 10),
  morePoints: (playground, a, b) => {
    if (playground.work.source !== 'points') return
    for (const share of [1, 2, 3]) playground.addPoint((a * 10) / share, (b * 10) / share)
  },
  lessPoints: (playground, a) =>
    playground.work.source === 'points' &&
    playground.removePoint(Math.floor(a * playground.work.table.rows.length)),
  readings: (playground, a, b) => playground.collect([[a * 255, b * 255, 80]]),
  flags: (playground, a) => playground.setFlags(1 + Math.floor(a * 6)),
  throwFlags: (playground, a) =>
    playground.throwFlags((['random', '++', 'best'] as const)[Math.floor(a * 3)]!),
  distance: (playground, a) => playground.setDistance(a < 0.5 ? 'euclidean' : 'manhattan'),
  name: (playground, a) => playground.name(Math.floor(a * 3), 'Bo'),
  step: (playground) => playground.stepOne(),
  stepAll: (playground) => playground.stepAll(),
  play: (playground) => playground.play(),
  again: (playground) => playground.again(),
}
const kinds = Object.keys(edits)

/** Points of the child's own: drawn or from a file. */
const ownIn = ({ work }: Playground) =>
  work.source === 'points' && ['', OWN_TABLE].includes(work.set) ? work : null

interface Step {
  readonly kind: number
  readonly a: number
  readonly b: number
}

async function run(steps: readonly Step[], id: string): Promise<void> {
  await save(id, friendship, 0)
  let { playground, store } = await opened(id)
  /** Rows of each own set as they were left. */
  const left = new Map<string, string>()
  for (const { kind, a, b } of steps) {
    if (kind % 12 === 0) {
      playground.close()
      await store.autosave.flush()
      ;({ playground, store } = await opened(id))
    } else edits[kinds[kind % kinds.length]!]!(playground, a, b)
    vi.advanceTimersByTime(700)
    const own = ownIn(playground)
    const rows = own && JSON.stringify(own.table.rows)
    const looks = ['own', 'table', 'source', 'things', 'trap'].includes(kinds[kind % kinds.length]!)
    const before = own && left.get(own.set)
    if (before && (looks || kind % 12 === 0) && before !== rows)
      throw new Error(`Own points are lost: ${before} became ${rows}.`)
    if (own) left.set(own.set, rows!)
  }
  playground.close()
  await store.autosave.flush()
}

test('own points are there again after a look at other sets, and after a reload', async () => {
  let number = 0
  let failed = 0
  const step = fc.record({
    kind: fc.nat(),
    a: fc.double({ min: 0, max: 0.999, noNaN: true }),
    b: fc.double({ min: 0, max: 0.999, noNaN: true }),
  })
  const property = fc.asyncProperty(fc.array(step, { minLength: 8, maxLength: 24 }), async (steps) => {
    try {
      await run(steps, `sorting-${number++}`)
    } catch (cause) {
      if (!counts) throw cause
      failed += 1
    }
  })
  await fc.assert(property, { numRuns: sequences })
  if (counts) console.log(`${failed} of ${sequences} sequences failed.`)
}, 3_600_000)
