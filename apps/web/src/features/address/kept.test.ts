import 'fake-indexeddb/auto'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { save } from '#storage/projects.ts'
import { freshDevice, putDevice } from '#storage/testing/device.ts'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { friendship } from '#storage/testing/sample.ts'
import { announcedElsewhere, stay } from './elsewhere.ts'
import { keptHere, wayTo } from './kept.ts'

beforeEach(async () => {
  await freshDevice()
  freshLocalStorage()
})
afterEach(() => void vi.unstubAllGlobals())

describe('what is saved under this address', () => {
  test('is counted, with what cannot be read', async () => {
    expect(await keptHere()).toEqual({ own: 0, others: false })
    await save('one', friendship, 0)
    await save('two', friendship, 0)
    expect(await keptHere()).toEqual({ own: 2, others: false })
  })

  test('is counted although it is damaged', async () => {
    const damaged = { id: 'x', project: { name: 'x' }, changed: 1, revision: 1 }
    await putDevice({ name: 'botgarten', version: 2, stores: { projects: [damaged], bin: [] } } as never)
    expect((await keptHere()).own).toBe(1)
  })
})

describe('the way to the announced address', () => {
  const announced = 'https://192.168.1.5:4174'

  test('leads to its home page, for a pupil who joins to the same door', () => {
    expect(wayTo(announced, { pathname: '/lab/free', hash: '#x' })).toBe(`${announced}/`)
    expect(wayTo(announced, { pathname: '/join', hash: '#code' })).toBe(`${announced}/join#code`)
  })
})

describe('a user who stays', () => {
  const byName = { hostname: 'laptop.fritz.box', origin: 'http://laptop.fritz.box:4173' }
  const fetch = () => Promise.resolve(Response.json({ address: 'http://192.168.0.5:4173' }))

  test('is not asked again in this tab', async () => {
    const texts = new Map<string, string>()
    vi.stubGlobal('sessionStorage', {
      getItem: (key: string) => texts.get(key) ?? null,
      setItem: (key: string, text: string) => texts.set(key, text),
    })
    expect(await announcedElsewhere(byName, fetch)).toBe('http://192.168.0.5:4173')
    stay()
    expect(await announcedElsewhere(byName, fetch)).toBeNull()
  })

  test('is asked once more where the browser refuses to note it', async () => {
    const refuse = () => {
      throw new DOMException('Refused for a test.', 'SecurityError')
    }
    vi.stubGlobal('sessionStorage', { getItem: refuse, setItem: refuse })
    stay()
    expect(await announcedElsewhere(byName, fetch)).toBe('http://192.168.0.5:4173')
  })
})
