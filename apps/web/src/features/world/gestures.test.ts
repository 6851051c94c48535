import { expect, test } from 'vitest'
import { Gestures } from './gestures.ts'

const at = (x: number, y: number) => ({ x, y })

test('one finger pushes the floor', () => {
  const hand = new Gestures()
  hand.down(1, at(100, 100))
  expect(hand.move(1, at(110, 95))).toEqual({ right: 10, down: -5, factor: 1, at: at(110, 95) })
  expect(hand.move(1, at(111, 95))).toMatchObject({ right: 1, down: 0 })
})

test('two fingers that part bring it nearer, at the point between them', () => {
  const hand = new Gestures()
  hand.down(1, at(100, 100))
  hand.down(2, at(200, 100))
  expect(hand.move(2, at(300, 100))).toEqual({ right: 50, down: 0, factor: 2, at: at(200, 100) })
  hand.up(1)
  expect(hand.move(2, at(310, 100))).toMatchObject({ right: 10, factor: 1 })
})

test('fingers that come together in one point do not throw the floor away', () => {
  const hand = new Gestures()
  hand.down(1, at(100, 100))
  hand.down(2, at(104, 100))
  expect(hand.move(2, at(100, 100))?.factor).toBe(1)
})

test('a third finger, and one that never came down, do nothing', () => {
  const hand = new Gestures()
  hand.down(1, at(0, 0))
  hand.down(2, at(100, 0))
  hand.down(3, at(50, 50))
  expect(hand.move(3, at(90, 90))).toBeNull()
  expect(hand.move(9, at(0, 0))).toBeNull()
})
