import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { createLab } from '@botgarten/lab'
import { beginNight, learnedOf, ticksOf } from '@botgarten/lab/trying'
import { tryingIn, type Project } from '@botgarten/programs'
import { paintFloor } from '@botgarten/simulation'
import { afterEach, beforeAll, describe, expect, test, vi } from 'vitest'
import type { LoadedCard } from '#content/cards.ts'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { withRobot } from '#lab/robots.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { inWorker, type Ears } from './in-worker.ts'
import { Night } from './night.svelte.ts'
import { sleep, type Asked } from './sleep.ts'

beforeAll(() => addBlocks(learning))
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

const { card, world } = content.card('try-dodge')!
const minute = JSON.parse(
  JSON.stringify(content.program('try-dodge', 'solution')!.programs).replace(
    '"MINUTES":"8"',
    '"MINUTES":"1"',
  ),
) as Project['programs']
const project = cardProject(world, card, { programs: minute, brains: {} }, 'try-dodge')
const paid = (coins: string) =>
  JSON.parse(JSON.stringify(minute).replace('"COINS":"-5"', `"COINS":"${coins}"`)) as Project['programs']
const floorOf = (one: Project) => paintFloor({ ...one.world, floor: { colour: '#FFFFFF' } })

const nightOf = (session: LabSession, begin = inWorker) => new Night(session, () => {}, begin)

/** A whole night in no time. */
const atOnce = (asked: Asked, { hear }: Ears) => {
  sleep(asked, hear, () => 0)
  return () => {}
}

/** A night that goes on until it is told that it is over. */
function slowly() {
  const nights: { readonly asked: Asked; readonly ears: Ears; woken: boolean }[] = []
  const begin = (asked: Asked, ears: Ears) => {
    const one = { asked, ears, woken: false }
    nights.push(one)
    return () => void (one.woken = true)
  }
  return { begin, nights }
}

async function sessionFor(one: Project = project) {
  await freshDevice()
  return sessionOf(one, { isCard: false }).session
}

/** What the lab learns from the same project, tick by tick. */
function inLab(one: Project) {
  const lab = createLab()
  lab.load(one, floorOf(one), { seed: 1, checks: [] })
  lab.start()
  lab.advance(3700)
  return lab.document().tables
}

describe('a night', () => {
  test('puts into the lab what the lab itself would have learned, to the same bits', async () => {
    const session = await sessionFor()
    const night = nightOf(session, atOnce)
    night.begin()
    expect(night).toMatchObject({ ending: 'learned', isAsleep: false })
    expect(session.project.tables).toEqual(inLab(project))
    expect(night.shown).toMatchObject({ total: 3600, stuck: 0 })
    expect(night.shown.curve).toHaveLength(1)
    session.start()
    expect(session.lab.facts.problem).toBeNull()
    night.begin()
    expect(night.ending).toBe('already')
  })

  test('is saved like every change, and can be taken back', async () => {
    const session = await sessionFor()
    nightOf(session, atOnce).begin()
    expect(session.autosave.state).toBe('saving')
    session.undo.undo()
    expect(session.project.tables).toEqual({})
    session.undo.redo()
    expect(session.project.tables).toEqual(inLab(project))
  })

  test('stands on the bill: the time of the computer and the bumps, also of one that was stopped', async () => {
    const session = await sessionFor()
    let now = 0
    vi.spyOn(performance, 'now').mockImplementation(() => now)
    const { begin, nights } = slowly()
    const night = nightOf(session, begin)
    night.begin()
    now = 2000
    nights[0]!.ears.hear({ total: 1800, curve: [], bumps: 3, stuck: 0, table: null })
    night.end()
    expect(session.project.effort).toMatchObject({ computer: 2, bumps: 3 })
    night.begin()
    now = 3000
    sleep(nights[1]!.asked, nights[1]!.ears.hear, () => 0)
    const { bumps } = night.shown.curve[0]!
    expect(session.project.effort).toMatchObject({ computer: 3, bumps: 3 + bumps })
    vi.restoreAllMocks()
  })

  test('is of the robot that is chosen; the other one stands still', async () => {
    const { id, document } = withRobot(project, 'bo', 'own')
    const two = { ...project, ...document }
    const session = await sessionFor(two)
    session.choose(id)
    nightOf(session, atOnce).begin()
    const { id: block, trial } = tryingIn(two.programs[id]!)!
    const alone = beginNight(two.world, floorOf(two), trial, 1)
    alone.advance(ticksOf(1))
    expect(session.project.tables).toEqual({ [block]: learnedOf(alone.state) })
  })

  test('reports while it goes on, and is woken up by a hand', async () => {
    const session = await sessionFor()
    const { begin, nights } = slowly()
    const night = nightOf(session, begin)
    night.begin()
    const [first] = nights
    first!.ears.hear({ total: 1800, curve: [], bumps: 3, stuck: 0, table: null })
    expect(night).toMatchObject({ isAsleep: true, ticks: 3600, shown: { total: 1800 } })
    night.end()
    expect(night).toMatchObject({ isAsleep: false, ending: 'stopped' })
    expect(first!.woken).toBe(true)
    expect(session.project.tables).toBeUndefined()
  })

  test.each([
    ['its pay', { kind: 'program', program: 'main', after: paid('-10').main! }],
    ['where Bo starts', { kind: 'place', id: 'bo', after: { x: 300, y: 70, heading: 0 } }],
  ] as const)('ends where a hand changes %s meanwhile: it would be of another Bo', async (_what, change) => {
    const session = await sessionFor()
    const { begin, nights } = slowly()
    const night = nightOf(session, begin)
    night.begin()
    session.apply(change)
    expect(night.ending).toBe('changed')
    sleep(nights[0]!.asked, nights[0]!.ears.hear, () => 0)
    expect(session.project.tables).toBeUndefined()
  })

  test('goes on where a hand changes what it does not need', async () => {
    const session = await sessionFor()
    const { begin } = slowly()
    const night = nightOf(session, begin)
    night.begin()
    session.rename('Mine')
    session.apply({ kind: 'shelf', after: 'all' })
    expect(night.isAsleep).toBe(true)
  })

  test('says that its worker died, or that there is none, and begins again when it is asked', async () => {
    const session = await sessionFor()
    vi.stubGlobal('Worker', undefined)
    const none = nightOf(session)
    none.begin()
    expect(none).toMatchObject({ ending: 'died', isAsleep: false })
    let isKilled = false
    vi.stubGlobal(
      'Worker',
      class {
        onerror: (() => void) | null = null
        postMessage = () => this.onerror?.()
        terminate = () => void (isKilled = true)
      },
    )
    const night = nightOf(session, inWorker)
    night.begin()
    expect(night.ending).toBe('died')
    expect(isKilled).toBe(true)
  })

  test('begins its tries at all places of the card where a child wants that', () => {
    const session = sessionOf(project, { card: { card } as LoadedCard }).session
    const set = vi.fn()
    const night = new Night(session, set, atOnce)
    expect(night).toMatchObject({ places: card.starts, fromAll: false })
    night.fromAll = true
    expect(set).toHaveBeenLastCalledWith('try', { STARTS: '110 190, 300 70, 480 330' })
    night.fromAll = false
    expect(set).toHaveBeenLastCalledWith('try', { STARTS: '' })
  })

  test('has no places without a card, and does not begin without a block that tries', async () => {
    const { begin, nights } = slowly()
    const programs = { main: { ...minute['main']!, stacks: [] } }
    const night = nightOf(await sessionFor({ ...project, programs }), begin)
    expect(night).toMatchObject({ places: [], fromAll: false })
    night.begin()
    expect([night.isAsleep, night.ending, nights]).toEqual([false, null, []])
  })

  test('does not begin where there is nothing to learn for', async () => {
    const night = nightOf(await sessionFor({ ...project, programs: paid('0') }), atOnce)
    night.begin()
    expect(night.ending).toBe('learned')
    const unpaid = JSON.parse(
      JSON.stringify(minute).replace(/"COINS":"-?\d+"/g, '"COINS":"0"'),
    ) as typeof minute
    const other = nightOf(await sessionFor({ ...project, programs: unpaid }), atOnce)
    other.begin()
    expect(other).toMatchObject({ ending: 'tryNoPay', isAsleep: false })
  })
})
