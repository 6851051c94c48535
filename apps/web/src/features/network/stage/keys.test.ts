import { expect, test } from 'vitest'
import { stepped } from './keys.ts'

test('arrows step by 0.05, with Shift by 0.2, inside 0..1; Home and End go to the ends', () => {
  expect(stepped({ key: 'ArrowRight', shiftKey: false }, 0.3)).toBe(0.35)
  expect(stepped({ key: 'ArrowDown', shiftKey: true }, 0.3)).toBe(0.1)
  expect(stepped({ key: 'ArrowDown', shiftKey: true }, 0.1)).toBe(0)
  expect(stepped({ key: 'ArrowUp', shiftKey: false }, 0.98)).toBe(1)
  expect([
    stepped({ key: 'Home', shiftKey: false }, 0.5),
    stepped({ key: 'End', shiftKey: false }, 0.5),
  ]).toEqual([0, 1])
  expect(stepped({ key: 'a', shiftKey: false }, 0.5)).toBeNull()
})
