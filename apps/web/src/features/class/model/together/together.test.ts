import { migrate, openSqlite } from '@botgarten/classroom'
import { quickAccounts, Server } from '@botgarten/classroom/testing'
import type { Block } from '@botgarten/blocks'
import { sceneOf } from '@botgarten/programs'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { withRobot } from '#lab/robots.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import type { Packs } from '#lab/opening.ts'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { askAs, type Ask } from '#storage/ask.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { PupilLive } from '../live.svelte.ts'
import { invite } from './pairing.ts'
import { Together } from './together.svelte.ts'

// Two sessions as the screen has them, and a real class server between them. Only clock and cable are not.
type Pupil = Awaited<ReturnType<Server['pupil']>>
interface Child {
  session: LabSession
  readonly ask: Ask
  together: Together
  isPlugged: boolean
  /** The status that the class answers to its operations; 0: its own. */
  refusal: number
}
/** Which blocks the pages have asked for. */
let asked: string[]
/** Blocks arrive after this. */
let coming: Promise<void>
const packs: Packs = {
  loadLearning: () => Promise.resolve(),
  async loadFor({ programs }) {
    asked.push(JSON.stringify(programs))
    await coming
    return false
  },
}
let server: Server
let pupils: readonly [Pupil, Pupil]
/** A classmate who works alone. */
let mate: Pupil
let fox: Child
let owl: Child

/** Both pages and the server do what they have to. */
async function passes(seconds: number) {
  for (let at = 0; at < seconds * 4; at++) {
    vi.advanceTimersByTime(250)
    for (let turn = 0; turn < 30; turn++) await new Promise((done) => setImmediate(done))
  }
}

function asker({ browser, id }: Pupil, child: Pick<Child, 'isPlugged' | 'refusal'>): Ask {
  const cookie = [...browser.cookies].map(([name, value]) => `${name}=${value}`).join('; ')
  return askAs(id, (path, init) => {
    if (!child.isPlugged) return Promise.reject(new TypeError('The cable is out.'))
    if (child.refusal > 0 && path.endsWith('/pair/operations'))
      return Promise.resolve(Response.json({ error: 'refused' }, { status: child.refusal }))
    const headers = new Headers(init.headers)
    headers.set('cookie', cookie)
    headers.set('origin', 'http://lab.test')
    return server.ask(new Request(`http://lab.test${path}`, { ...init, headers }))
  })
}

beforeEach(async () => {
  asked = []
  coming = Promise.resolve()
  await freshDevice()
  const database = openSqlite(':memory:')
  await migrate(database)
  server = new Server(database, quickAccounts(database))
  const { code } = await server.openClass(await server.firstTeacher())
  pupils = [await server.pupil(code, 'Fuchs'), await server.pupil(code, 'Eule')]
  mate = await server.pupil(code, 'Dachs')
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'setInterval', 'clearInterval'] })
  const children = pupils.map((pupil) => {
    const child = { isPlugged: true, refusal: 0 } as { -readonly [Key in keyof Child]: Child[Key] }
    child.ask = asker(pupil, child)
    child.session = sessionOf().session
    return child
  })
  const { session, ask } = children[0]!
  expect(await invite(ask, pupils[1].id, { id: 'friendship', project: session.project })).toBeNull()
  const me = (await pupils[1].browser.get('/me')).body as { pair: { id: string } }
  await pupils[1].browser.put('/pair/answer', { pair: me.pair.id, yes: true })
  for (const child of children) {
    const live = new PupilLive(child.ask, { me: () => {}, over: () => {} })
    child.together = new Together(live, child.session, me.pair.id, packs, () => {})
  }
  ;[fox, owl] = children as [Child, Child]
  await passes(1)
})
afterEach(() => {
  for (const { together } of [fox, owl]) together.stop()
  closeSessions()
  vi.useRealTimers()
})

const turn = ({ session }: Child, to: number, wheel = 'wheelRight') =>
  session.weights.turn('net', 'eyeLeft', wheel, to, 'whole')
const weight = ({ session }: Child, wheel = 'wheelRight') =>
  session.lab.document.brains['net']?.weights['eyeLeft']?.[wheel] ?? 0
const main = ({ session }: Child) => session.lab.document.programs['main']!

/** A block that stands alone. */
function adds(child: Child, id: string) {
  const block: Block = { id, type: 'robActions_motorDiff_stop' }
  const after = { ...main(child), stacks: [...main(child).stacks, { x: 300, y: 300, blocks: [block] }] }
  child.session.apply({ kind: 'program', program: 'main', after })
}
/** The number of operations that the class has of the two. */
const lengthInClass = async () => ((await pupils[1].browser.get('/pair')).body as { length: number }).length
const same = () => {
  for (const part of ['programs', 'brains', 'world'] as const)
    expect(owl.session.project[part]).toEqual(fox.session.project[part])
}

test('what one does the other has soon, and the other way round', async () => {
  turn(fox, 0.4)
  await passes(6)
  expect(weight(owl)).toBe(0.4)
  adds(owl, 'new')
  await passes(6)
  expect(main(fox).stacks.at(-1)!.blocks[0]!.id).toBe('new')
  same()
})

test('both go on while the cable of one is out, and then have both', async () => {
  fox.isPlugged = false
  turn(fox, 0.7)
  adds(fox, 'of-fox')
  await passes(3)
  expect(fox.together.isAway).toBe(true)
  adds(owl, 'of-owl')
  turn(owl, -0.2, 'wheelLeft')
  await passes(3)
  fox.isPlugged = true
  await passes(12)
  same()
  expect([weight(fox), weight(fox, 'wheelLeft'), fox.together.isAway]).toEqual([0.7, -0.2, false])
  const ids = main(owl).stacks.map(({ blocks }) => blocks[0]!.id)
  expect(ids).toEqual(expect.arrayContaining(['of-fox', 'of-owl']))
})

test('undo takes back only the own steps, and redo does them again', async () => {
  turn(fox, 0.7)
  await passes(6)
  adds(owl, 'of-owl')
  await passes(6)
  fox.session.undo.undo()
  await passes(6)
  expect([weight(owl), main(fox).stacks.at(-1)!.blocks[0]!.id]).toEqual([0, 'of-owl'])
  fox.session.undo.redo()
  await passes(6)
  expect(weight(owl)).toBe(0.7)
})

test('undo reverts the step of this moment, not the one before it', async () => {
  turn(fox, 0.4)
  await passes(1)
  turn(fox, 0.7)
  fox.session.undo.undo()
  expect(weight(fox)).toBe(0.4)
  turn(fox, 0.9)
  fox.session.undo.redo()
  expect(weight(fox)).toBe(0.9)
})

test('each page knows the other child before the class says anything new, and warns of nothing', () => {
  expect([fox.together.about?.with, owl.together.about?.with]).toEqual(['Eule', 'Fuchs'])
  expect([fox.together.hadPhoto, fox.together.isFull]).toEqual([false, false])
})

test('a child that works with another child cannot invite a third one', async () => {
  const own = { id: 'friendship', project: fox.session.project }
  expect(await invite(fox.ask, mate.id, own)).toBe('togetherBusy')
  const askOfMate = asker(mate, { isPlugged: true, refusal: 0 })
  expect(await invite(askOfMate, pupils[0].id, own)).toBe('togetherBusy')
  expect(await invite(askOfMate, mate.id, own)).toBe('togetherNotSent')
  fox.isPlugged = false
  expect(await invite(fox.ask, mate.id, own)).toBe('togetherNotSent')
})

test.each([400, 409, 413])('a class that takes no more of it (%i) ends the common work', async (status) => {
  fox.refusal = status
  turn(fox, 0.4)
  await passes(1)
  expect([fox.together.isFull, fox.together.isAway]).toEqual([true, false])
})

test('a class that is only too busy for a moment (429) gets it later', async () => {
  fox.refusal = 429
  turn(fox, 0.4)
  await passes(1)
  expect([fox.together.isFull, fox.together.isAway]).toEqual([false, false])
  expect(await lengthInClass()).toBe(0)
  fox.refusal = 0
  await passes(2)
  expect([fox.together.isFull, await lengthInClass()]).toEqual([false, 1])
})

test('more than the class takes at once is sent without a pause, and fetched without a pause', async () => {
  fox.isPlugged = false
  const { stacks } = main(fox)
  const more = Array.from({ length: 450 }, (_, at): Block => ({
    id: `new-${at}`,
    type: 'robActions_motorDiff_stop',
  }))
  const after = {
    ...main(fox),
    stacks: [...stacks, ...more.map((block, at) => ({ x: at, y: 0, blocks: [block] }))],
  }
  fox.session.apply({ kind: 'program', program: 'main', after })
  await passes(1)
  fox.isPlugged = true
  await passes(2)
  expect(await lengthInClass()).toBe(450)
  await passes(5)
  same()
})

test('a page that the class does not answer at its beginning waits, and then has all of it', async () => {
  fox.together.stop()
  fox.isPlugged = false
  const live = new PupilLive(fox.ask, { me: () => {}, over: () => {} })
  fox.together = new Together(live, fox.session, fox.together.pair, packs, () => {})
  turn(owl, 0.4)
  await passes(12)
  expect([fox.together.isAway, fox.together.about, weight(fox)]).toEqual([true, null, 0])
  fox.isPlugged = true
  await passes(6)
  expect([fox.together.isAway, weight(fox)]).toEqual([false, 0.4])
})

test('blocks of the other child are shown only after they have arrived, also after undo', async () => {
  turn(fox, 0.4)
  await passes(6)
  let come = () => {}
  coming = new Promise((resolve) => (come = resolve))
  adds(owl, 'of-owl')
  await passes(6)
  fox.session.undo.undo()
  const ids = () => main(fox).stacks.map(({ blocks }) => blocks[0]!.id)
  expect(ids()).not.toContain('of-owl')
  come()
  await passes(6)
  expect(ids()).toContain('of-owl')
  expect([weight(fox), weight(owl)]).toEqual([0, 0])
})

test('a thing that is moved stands there for both', async () => {
  fox.session.apply({ kind: 'place', id: 'bo', after: { x: 120, y: 200, heading: 1 } })
  await passes(6)
  same()
})

test('a block in a hand is not taken out of it', async () => {
  owl.session.settleBlocks = () => false
  turn(fox, 0.4)
  await passes(6)
  expect(weight(owl)).toBe(0)
  owl.session.settleBlocks = () => true
  await passes(6)
  expect(weight(owl)).toBe(0.4)
})

describe('a page that is opened again', () => {
  /** The page goes, and comes with the project that the device has. */
  async function reopens(child: Child, { saved = child.session.project, early = () => {} } = {}) {
    child.together.stop()
    const live = new PupilLive(child.ask, { me: () => {}, over: () => {} })
    child.session = sessionOf(saved).session
    const { pair } = child.together
    const wasPlugged = child.isPlugged
    child.isPlugged = false
    child.together = new Together(live, child.session, pair, packs, () => {})
    await passes(1)
    early()
    child.isPlugged = wasPlugged
    await passes(8)
  }

  test('has what it did last, also where nobody has noted it, and what it does before the class answers', async () => {
    turn(fox, 0.4)
    await passes(6)
    turn(fox, 0.6)
    adds(fox, 'last')
    await reopens(fox, { early: () => adds(fox, 'early') })
    const ids = main(owl).stacks.map(({ blocks }) => blocks[0]!.id)
    expect(ids).toEqual(expect.arrayContaining(['last', 'early']))
    expect(weight(owl)).toBe(0.6)
    same()
  })

  test('has what it did in its last moment, also where the device has saved an earlier program', async () => {
    const saved = fox.session.project
    turn(fox, 0.6)
    fox.together.note()
    await reopens(fox, { saved })
    expect([weight(fox), weight(owl)]).toEqual([0.6, 0.6])
    same()
  })

  test('takes nothing of the other one back where the device has saved an earlier program', async () => {
    const saved = fox.session.project
    turn(owl, 0.5)
    await passes(6)
    adds(owl, 'of-owl')
    await passes(6)
    await reopens(fox, { saved })
    expect([weight(owl), main(fox).stacks.at(-1)!.blocks[0]!.id]).toEqual([0.5, 'of-owl'])
    same()
  })
})

test('while Bo drives knobs turn, and other blocks wait until it stands', async () => {
  fox.session.start()
  adds(owl, 'of-owl')
  turn(owl, 0.3)
  await passes(6)
  expect([weight(fox), main(fox).stacks.length < main(owl).stacks.length]).toEqual([0.3, true])
  expect([fox.session.lab.facts.phase, fox.together.waits]).toEqual(['running', true])
  fox.session.lab.stop()
  await passes(1)
  same()
  expect(fox.together.waits).toBe(false)
})

test('an own photo goes to nobody: the floor is as it was, and the child is told', async () => {
  const before = fox.session.lab.document.world.floor
  const photo = 'b'.repeat(64)
  const scene = { ...sceneOf(fox.session.lab.document.world), floor: { asset: photo } }
  const pictures = { [photo]: { type: 'image/png' as const, base64: 'iVBORw0KGgo=' } }
  fox.session.apply({ kind: 'scene', after: scene, pictures })
  await passes(6)
  expect([fox.session.lab.document.world.floor, fox.together.hadPhoto]).toEqual([before, true])
  same()
  turn(fox, 0.2)
  await passes(6)
  expect(fox.together.hadPhoto).toBe(false)
})

test('blocks that the other one has used are asked for before they are shown', async () => {
  adds(owl, 'of-owl')
  asked = []
  await passes(6)
  expect(asked.some((programs) => programs.includes('of-owl'))).toBe(true)
  same()
})

test('a second robot comes for both, with a program of its own where the other one may be', async () => {
  const { id, document } = withRobot(fox.session.lab.document, fox.session.robotId, 'own')
  fox.session.apply({ kind: 'robots', after: document })
  await passes(6)
  same()
  fox.session.choose(id)
  expect(fox.together.program).toBe(id)
  owl.together.hand = { program: id, at: null, x: 0, y: 0, chosen: null }
  expect(owl.together.elsewhere).toBe(1)
  owl.session.choose(id)
  expect(owl.together.elsewhere).toBe(null)
})
