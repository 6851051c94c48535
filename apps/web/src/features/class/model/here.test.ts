import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { arrive, beginning, forgetHere, stayHere, whenQuiet } from './here.ts'

const minute = 60_000
let page: EventTarget
let asked: number

beforeEach(() => {
  vi.useFakeTimers()
  page = new EventTarget()
  asked = 0
  vi.stubGlobal('addEventListener', page.addEventListener.bind(page))
  vi.stubGlobal('removeEventListener', page.removeEventListener.bind(page))
})
afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

const touch = (kind: 'keydown' | 'pointerdown') => page.dispatchEvent(new Event(kind))

test('ten minutes without a key or a finger, and it is asked who sits there, once', () => {
  whenQuiet(() => asked++)
  for (const kind of ['keydown', 'pointerdown'] as const) {
    vi.advanceTimersByTime(9 * minute)
    touch(kind)
  }
  vi.advanceTimersByTime(9 * minute)
  expect(asked).toBe(0)
  vi.advanceTimersByTime(2 * minute)
  expect(asked).toBe(1)
  vi.advanceTimersByTime(60 * minute)
  expect(asked).toBe(1)
})

test('a laptop that slept asks at the first touch, before anything else', () => {
  whenQuiet(() => asked++)
  vi.setSystemTime(Date.now() + 11 * minute)
  touch('keydown')
  expect(asked).toBe(1)
})

test('stopped, it asks nobody', () => {
  const stop = whenQuiet(() => asked++)
  stop()
  vi.advanceTimersByTime(20 * minute)
  expect(asked).toBe(0)
})

/** An empty session storage. Returns its entries. */
function freshTab(): Map<string, string> {
  const texts = new Map<string, string>()
  vi.stubGlobal('sessionStorage', {
    getItem: (key: string) => texts.get(key) ?? null,
    setItem: (key: string, text: string) => void texts.set(key, text),
    removeItem: (key: string) => void texts.delete(key),
  })
  return texts
}

test('a tab asks no more once its child is here, and asks every other child', () => {
  freshTab()
  expect(beginning('fox')).toBe('asks')
  arrive('fox', 'new')
  expect([beginning('fox'), beginning('owl')]).toEqual(['here', 'asks'])
  arrive('owl', 'back')
  expect([beginning('fox'), beginning('owl')]).toEqual(['asks', 'back'])
  stayHere('owl')
  expect(beginning('owl')).toBe('here')
  forgetHere()
  expect(beginning('owl')).toBe('asks')
})

test('a tab that an earlier version has left open in a lesson does not ask after its update', () => {
  freshTab().set('botgarten.here', 'fox')
  expect(beginning('fox')).toBe('here')
})
