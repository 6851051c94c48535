import { expect, test } from 'vitest'
import { buttonSide } from './button-side.ts'

const viewport = { pane: { width: 400, height: 300 }, scale: 1, corner: { x: 0, y: 0 } }
const at = (x: number, down: number) => ({ pose: { x, y: 300 - down, heading: 0 } })

test('buttons stand on the left, change sides where a robot is under them, and stay there', () => {
  const side = buttonSide()
  expect(side([at(200, 150)], viewport, 300)).toBe('left')
  expect(side([at(40, 40), at(200, 150)], viewport, 300)).toBe('right')
  expect(side([at(200, 150)], viewport, 300)).toBe('right')
  expect(side([at(380, 20)], viewport, 300)).toBe('left')
})

test('buttons stay where both corners are taken', () => {
  expect(buttonSide()([at(10, 10), at(390, 10)], viewport, 300)).toBe('left')
})

test('a robot is under the buttons as soon as its rim is', () => {
  // The buttons are 60 px high, and the rim is 12 cm from the middle, at 1 px per cm.
  expect(buttonSide()([at(40, 71)], viewport, 300)).toBe('right')
  expect(buttonSide()([at(40, 73)], viewport, 300)).toBe('left')
})

test('a pane of 560 × 280 px has three buttons, and a lower or narrower one has a single button', () => {
  const pane = (width: number, height: number) => ({ ...viewport, pane: { width, height } })
  const robot = [{ pose: { x: 100, y: 280, heading: 0 } }]
  expect(buttonSide()(robot, pane(560, 280), 300)).toBe('right')
  expect(buttonSide()(robot, pane(560, 279), 300)).toBe('left')
  expect(buttonSide()(robot, pane(559, 280), 300)).toBe('left')
})
