import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { askLasting, quietlyAskLasting } from './lasting.ts'

beforeEach(() => void vi.spyOn(console, 'warn').mockImplementation(() => {}))
afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

/** A browser that answers so; `asked` counts how often it was asked to keep things. */
function browser({ persisted = false, persist = true, permission = 'prompt' as PermissionState | null }) {
  const asked = { times: 0 }
  const storage = {
    persisted: () => Promise.resolve(persisted),
    persist: () => Promise.resolve(++asked.times > 0 && persist),
  }
  const query = ({ name }: { name: string }) =>
    permission !== null && name === 'persistent-storage'
      ? Promise.resolve({ state: permission })
      : Promise.reject(new TypeError('Unknown for a test.'))
  vi.stubGlobal('navigator', { storage, permissions: { query } })
  return asked
}

describe('asking without disturbing anybody', () => {
  test.each([
    ['what lasts already lasts', { persisted: true }, 'lasting', 0],
    ['where it is allowed it is taken', { permission: 'granted' }, 'lasting', 1],
    ['allowed and refused all the same', { permission: 'granted', persist: false }, 'passing', 1],
    ['where it was refused nobody is asked again', { permission: 'denied' }, 'passing', 0],
    ['where the child would be asked it is not', { permission: 'prompt' }, 'asking', 0],
    ['a browser that does not know the question', { permission: null }, 'asking', 0],
  ] as const)('%s', async (_, answers, said, times) => {
    const asked = browser(answers)
    expect(await quietlyAskLasting()).toBe(said)
    expect(asked.times).toBe(times)
  })

  test('a page over plain http cannot know', async () => {
    vi.stubGlobal('navigator', {})
    expect(await quietlyAskLasting()).toBe('unsaid')
    vi.stubGlobal('navigator', { storage: {} })
    expect(await quietlyAskLasting()).toBe('unsaid')
  })

  test('a browser that fails has not said it', async () => {
    vi.stubGlobal('navigator', {
      storage: { persist: () => {}, persisted: () => Promise.reject(new Error('For a test.')) },
    })
    expect(await quietlyAskLasting()).toBe('unsaid')
  })
})

test('a child that presses is asked by the browser', async () => {
  const asked = browser({ permission: 'prompt' })
  expect(await askLasting()).toBe('lasting')
  expect(asked.times).toBe(1)
  browser({ persist: false })
  expect(await askLasting()).toBe('passing')
  vi.stubGlobal('navigator', {})
  expect(await askLasting()).toBe('passing')
  vi.stubGlobal('navigator', { storage: { persist: () => Promise.reject(new Error('For a test.')) } })
  expect(await askLasting()).toBe('passing')
})
