import { migrate, openSqlite } from '@botgarten/classroom'
import { quickAccounts, Server } from '@botgarten/classroom/testing'
import { settle, StreamSource } from '@botgarten/classroom/testing/event-source'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { allowed } from '#lab/allowed.svelte.ts'
import { askAs } from '#storage/ask.ts'
import { PupilLive, type Work } from './live.svelte.ts'
import type { Me } from './pupil.ts'
import { nowhere } from './report.ts'
import { SharedStream } from './shared-stream.ts'

let server: Server
let teacher: Awaited<ReturnType<Server['firstTeacher']>>
let school: { id: string; code: string }
let fox: Awaited<ReturnType<Server['pupil']>>
let live: PupilLive
let known: Me | null
let over: number
let isPlugged: boolean
let streams: number

const silent = { onmessage: null, postMessage: () => {}, close: () => {} }

/** A page that is looked at. */
function stubPage() {
  const page = new EventTarget()
  vi.stubGlobal('addEventListener', page.addEventListener.bind(page))
  vi.stubGlobal('removeEventListener', page.removeEventListener.bind(page))
  vi.stubGlobal('document', Object.assign(new EventTarget(), { visibilityState: 'visible' }))
}

/** A browser's cookies, and a network that can be cut. */
function askerOf({ browser }: typeof fox) {
  const cookie = [...browser.cookies].map(([name, value]) => `${name}=${value}`).join('; ')
  return (path: string, init: RequestInit = {}) => {
    if (!isPlugged) return Promise.reject(new TypeError('The cable is out.'))
    const headers = new Headers(init.headers)
    headers.set('cookie', cookie)
    headers.set('origin', 'http://lab.test')
    return server.ask(new Request(`http://lab.test${path}`, { ...init, headers }))
  }
}

beforeEach(async () => {
  stubPage()
  vi.useFakeTimers({ toFake: ['Date', 'setInterval', 'clearInterval', 'setTimeout', 'clearTimeout'] })
  const database = openSqlite(':memory:')
  await migrate(database)
  server = new Server(database, quickAccounts(database))
  teacher = await server.firstTeacher()
  school = await server.openClass(teacher)
  fox = await server.pupil(school.code, 'Fuchs')
  known = null
  over = 0
  isPlugged = true
  streams = 0
  const ask = askerOf(fox)
  const openStream = () => {
    streams += 1
    return new StreamSource(ask('/api/class/me/stream'))
  }
  live = new PupilLive(
    askAs(fox.id, ask),
    { me: (me) => (known = me), over: () => (over += 1) },
    (hear) => new SharedStream(hear, openStream, silent),
  )
  live.start()
  await settle(server)
})
afterEach(() => {
  live.stop()
  allowed.set({ cards: null, level: null, gallery: false, asking: false })
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

/** Time of the page and of the server. */
async function passes(seconds: number) {
  for (let second = 0; second < seconds; second++) {
    server.passes(1000)
    vi.advanceTimersByTime(1000)
    if (second % 5 === 0) server.ports.live.tick()
    await settle(server)
  }
}

const tiles = async () =>
  ((await teacher.get(`/classes/${school.id}/live`)).body as { tiles: { live: object | null }[] }).tiles
const doTeach = async (method: 'put' | 'post', path: string, body: unknown) => {
  await teacher[method](`/classes/${school.id}${path}`, body)
  await settle(server)
}

describe('the page of a pupil', () => {
  test('says that it is there, and what its lab is at', async () => {
    expect(known).toMatchObject({ nickname: 'Fuchs', class: { name: '5b', open: true } })
    expect(await tiles()).toMatchObject([{ live: { card: null, running: false } }])
    const work: Work = {
      ...{ place: 'friendship', changedAt: Date.now() },
      report: () => ({ ...nowhere, card: 'friendship', checks: ['passed'], running: true }),
    }
    live.work(work)
    await settle(server)
    expect(await tiles()).toMatchObject([{ live: { card: 'friendship', checks: ['passed'], running: true } }])
  })

  test('shows who looks at its work, for as long as somebody does', async () => {
    await doTeach('post', `/pupils/${fox.id}/inside`, undefined)
    expect(live.inside).toEqual({ by: 'm.weber' })
    await passes(20)
    expect(live.inside).toBeNull()
  })

  test('looks to the front until the teacher lets it go', async () => {
    await doTeach('put', '/attention', { on: true })
    expect(live.attention).toBe(true)
    await doTeach('put', '/attention', { on: false })
    expect(live.attention).toBe(false)
  })

  test('is let go after ten minutes, also where nobody says so', async () => {
    await doTeach('put', '/attention', { on: true })
    const stream = await teacher.events(`/classes/${school.id}/stream`)
    // A teacher's page that reads on keeps the attention.
    const reading = stream.until(() => false).catch(() => {})
    await passes(590)
    expect(live.attention).toBe(true)
    await passes(15)
    expect(live.attention).toBe(false)
    await stream.stop()
    await reading
  })

  test('is let go 20 s after the cable was pulled, and knows all again when it is back', async () => {
    await doTeach('put', '/attention', { on: true })
    const stream = await teacher.events(`/classes/${school.id}/stream`)
    // The class itself does not end it: a teacher's page reads on.
    const reading = stream.until(() => false).catch(() => {})
    isPlugged = false
    await passes(15)
    expect(live.attention).toBe(true)
    await passes(10)
    expect(live.attention).toBe(false)
    await stream.stop()
    await reading
    await doTeach('post', '/handouts', { to: 'all', kind: 'hint', text: 'Look at the eyes.' })
    isPlugged = true
    expect(streams).toBe(1)
    await passes(6)
    expect(live.handouts).toMatchObject([{ kind: 'hint', text: 'Look at the eyes.' }])
    // The old stream may be dead without an error: a new one is opened, once.
    expect(streams).toBe(2)
  })

  test('keeps what was sent until the child puts it away', async () => {
    await doTeach('post', '/handouts', { to: [fox.id], kind: 'hint', card: 'friendship', hint: 2 })
    await doTeach('post', '/handouts', { to: [fox.id], kind: 'program', card: 'friendship' })
    expect(live.handouts.map(({ kind }) => kind).sort()).toEqual(['hint', 'program'])
    const hint = live.handouts.find(({ kind }) => kind === 'hint')!
    isPlugged = false
    expect(await live.putAway(hint.id)).toBe(false)
    isPlugged = true
    expect(await live.putAway(hint.id)).toBe(true)
    await settle(server)
    expect(live.handouts.map(({ kind }) => kind)).toEqual(['program'])
  })

  test('opens what is free today', async () => {
    live.work({ place: 'fear', changedAt: 0, report: () => nowhere })
    await doTeach('put', '/free', { cards: ['friendship'], level: 'plain' })
    expect([allowed.isOpen('friendship'), allowed.isOpen('fear'), allowed.isOpen('free')]).toEqual([
      ...[true, false, true],
    ])
    expect(live.closedPlace).toBe('fear')
    await doTeach('put', '/free', { cards: null, level: null })
    expect(live.closedPlace).toBeNull()
  })

  test('asks again who sits there when the lesson is over', async () => {
    await doTeach('post', '/close', undefined)
    expect(over).toBe(1)
    await passes(10)
    expect(over).toBe(1)
  })
})
