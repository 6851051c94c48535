import { migrate, openSqlite } from '@botgarten/classroom'
import { quickAccounts, Server } from '@botgarten/classroom/testing'
import type { Block } from '@botgarten/blocks'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { LabSession } from '#lab/session.svelte.ts'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { askAs, type Ask } from '#storage/ask.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { PupilLive } from '../live.svelte.ts'
import { invite } from './pairing.ts'
import { Together } from './together.svelte.ts'

// Two sessions as the screen has them, and a real class server between them. Only clock and cable are not.
interface Child {
  readonly session: LabSession
  readonly ask: Ask
  readonly together: Together
  isPlugged: boolean
}
let server: Server
let fox: Child
let owl: Child

/** Both pages and the server do what they have to. */
async function passes(seconds: number) {
  for (let at = 0; at < seconds * 4; at++) {
    vi.advanceTimersByTime(250)
    for (let turn = 0; turn < 30; turn++) await new Promise((done) => setImmediate(done))
  }
}

function asker({ browser, id }: Awaited<ReturnType<Server['pupil']>>, plugged: () => boolean): Ask {
  const cookie = [...browser.cookies].map(([name, value]) => `${name}=${value}`).join('; ')
  return askAs(id, (path, init) => {
    if (!plugged()) return Promise.reject(new TypeError('The cable is out.'))
    const headers = new Headers(init.headers)
    headers.set('cookie', cookie)
    headers.set('origin', 'http://lab.test')
    return server.ask(new Request(`http://lab.test${path}`, { ...init, headers }))
  })
}

beforeEach(async () => {
  await freshDevice()
  const database = openSqlite(':memory:')
  await migrate(database)
  server = new Server(database, quickAccounts(database))
  const { code } = await server.openClass(await server.firstTeacher())
  const pupils = [await server.pupil(code, 'Fuchs'), await server.pupil(code, 'Eule')] as const
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'setInterval', 'clearInterval'] })
  const children = pupils.map((pupil) => {
    const child = { isPlugged: true } as { -readonly [Key in keyof Child]: Child[Key] }
    child.ask = asker(pupil, () => child.isPlugged)
    child.session = sessionOf().session
    return child
  })
  const { session, ask } = children[0]!
  expect(await invite(ask, pupils[1].id, { id: 'friendship', project: session.project })).toBeNull()
  const me = (await pupils[1].browser.get('/me')).body as { pair: { id: string } }
  await pupils[1].browser.put('/pair/answer', { pair: me.pair.id, yes: true })
  for (const child of children) {
    const live = new PupilLive(child.ask, { me: () => {}, over: () => {} })
    child.together = new Together(live, child.session, me.pair.id, child.session.project, () => {})
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
  expect([weight(fox), weight(fox, 'wheelLeft'), fox.together.waiting]).toEqual([0.7, -0.2, 0])
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
