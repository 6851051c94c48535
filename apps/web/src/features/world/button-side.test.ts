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
