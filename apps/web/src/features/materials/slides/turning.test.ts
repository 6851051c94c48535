import { expect, test, afterEach, vi } from 'vitest'
import { swipes, together } from './turning.ts'

/** A place with nothing but what is pressed on it. */
function stage() {
  const swiped: string[] = []
  const place = Object.assign(new EventTarget(), { style: { touchAction: '' } })
  const leave = swipes((way) => swiped.push(way))(place as unknown as HTMLElement)
  const send = (type: string, clientX: number, clientY: number, pointerId = 1, pointerType = 'touch') =>
    place.dispatchEvent(Object.assign(new Event(type), { clientX, clientY, pointerId, pointerType }))
  return { swiped, place, leave, send }
}

test.each([
  ['to the left', 300, 100, 200, 110, ['left']],
  ['to the right', 100, 100, 200, 90, ['right']],
  ['not far enough', 100, 100, 159, 100, []],
  ['more down than across', 100, 100, 180, 160, []],
])('a finger that goes %s', (_, fromX, fromY, toX, toY, swiped) => {
  const { send, ...given } = stage()
  send('pointerdown', fromX, fromY)
  send('pointerup', toX, toY)
  expect(given.swiped).toEqual(swiped)
})

test('a mouse turns nothing, for it selects words', () => {
  const { send, swiped } = stage()
  send('pointerdown', 300, 100, 1, 'mouse')
  send('pointerup', 100, 100, 1, 'mouse')
  expect(swiped).toEqual([])
})

test('the finger that began is the one that ends, and each drawing counts once', () => {
  const { send, swiped } = stage()
  send('pointerdown', 300, 100, 1)
  send('pointerup', 100, 100, 2)
  expect(swiped).toEqual([])
  send('pointerup', 200, 100, 1)
  send('pointerup', 100, 100, 1)
  expect(swiped).toEqual(['left'])
})

test('pages can still be moved up and down and made larger, and who leaves hears nothing more', () => {
  const { send, swiped, place, leave } = stage()
  expect(place.style.touchAction).toBe('pan-y pinch-zoom')
  leave()
  send('pointerdown', 300, 100)
  send('pointerup', 100, 100)
  expect(swiped).toEqual([])
})

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
