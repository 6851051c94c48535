import { expect, test } from 'vitest'
import { swipes } from './swipes.ts'

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
