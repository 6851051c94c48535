import { afterEach, expect, test, vi } from 'vitest'
import { together } from './together.ts'

const open: { close: () => void }[] = []
/** A window of a deck that stands on a slide, and turns when it is told to. */
function windowOf(deck: string, at: number) {
  const shown = { at }
  const others = together(
    deck,
    () => shown.at,
    (to) => (shown.at = to),
  )
  open.push(others)
  return { shown, ...others }
}

afterEach(() => open.splice(0).forEach((one) => one.close()))

test('a window that opens goes where the others are', async () => {
  windowOf('deck', 6)
  const late = windowOf('deck', 0)
  late.ask()
  await vi.waitFor(() => expect(late.shown.at).toBe(6))
})

test('a slide that is turned is turned everywhere', async () => {
  const [wall, teacher, third] = [windowOf('deck', 0), windowOf('deck', 0), windowOf('deck', 2)]
  teacher.tell(3)
  await vi.waitFor(() => expect([wall.shown.at, third.shown.at]).toEqual([3, 3]))
})

test('another deck stays where it is', async () => {
  const [own, other] = [windowOf('one', 0), windowOf('two', 5)]
  const teacher = windowOf('one', 0)
  teacher.tell(4)
  await vi.waitFor(() => expect(own.shown.at).toBe(4))
  expect(other.shown.at).toBe(5)
})

test('who has closed is told nothing', async () => {
  const [gone, own] = [windowOf('deck', 0), windowOf('deck', 0)]
  gone.close()
  windowOf('deck', 0).tell(2)
  await vi.waitFor(() => expect(own.shown.at).toBe(2))
  expect(gone.shown.at).toBe(0)
})
