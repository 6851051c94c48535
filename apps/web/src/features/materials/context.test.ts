import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { Waiting } from './context.ts'

beforeEach(() => vi.useFakeTimers())
afterEach(() => vi.useRealTimers())

/** A place on the page that notes what it is told: whoever observes an attribute hears every setting of it. */
function placeThatNotes() {
  const told: (string | null)[] = []
  const place = {
    getAttribute: () => told.at(-1) ?? null,
    setAttribute(name: string, busy: string) {
      if (name === 'aria-busy') told.push(busy)
    },
  }
  return { told, place: place as unknown as Element }
}

test('a place is busy until everything is there, and hears of it once however much there was', async () => {
  const waiting = new Waiting()
  const { told, place } = placeThatNotes()
  waiting.mark(place)
  const pictures = Array.from({ length: 50 }, (_, index) => waiting.for(Promise.resolve(index)))
  await Promise.all(pictures)
  expect(told).toEqual(['true'])
  await vi.runAllTimersAsync()
  expect(told).toEqual(['true', 'false'])
})

test('what comes a moment later keeps a place busy, and what fails does not keep it so', async () => {
  const waiting = new Waiting()
  const { told, place } = placeThatNotes()
  waiting.mark(place)
  await waiting.for(Promise.resolve())
  const lost = waiting.for(Promise.reject(new Error('gone')))
  await expect(lost).rejects.toThrow('gone')
  await vi.runAllTimersAsync()
  expect(told).toEqual(['true', 'false'])
})

test('where nothing is on its way a place is calm soon', async () => {
  const { told, place } = placeThatNotes()
  new Waiting().mark(place)
  await vi.runAllTimersAsync()
  expect(told.at(-1)).toBe('false')
})

test('a place that has left is told nothing more', async () => {
  const waiting = new Waiting()
  const { told, place } = placeThatNotes()
  waiting.mark(place)()
  await vi.runAllTimersAsync()
  expect(told).toEqual(['true'])
})
