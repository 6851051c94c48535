import { expect, test } from 'vitest'
import { coinFor, coinReach, drawCoin } from './coin.ts'

const middle = (shapes: ReturnType<typeof drawCoin>) => shapes[0] as { x: number; y: number; fill: string }

test('a coin lies above the robot, on the side that it does not look to', () => {
  const at = { x: 100, y: 100 }
  const east = middle(drawCoin({ text: '+1.1', gains: true }, at, 0, 24))
  const west = middle(drawCoin({ text: '+1.1', gains: true }, at, 180, 24))
  expect(east.x).toBeLessThan(at.x)
  expect(west.x).toBeGreaterThan(at.x)
  expect([east.y, west.y].every((y) => y < at.y)).toBe(true)
  const corner = { x: coinReach(24), y: coinReach(24) }
  expect(middle(drawCoin({ text: '1', gains: true }, corner, 0, 24))).toMatchObject({ x: 24, y: 24 })
})

test('what costs coins has another colour, and always its sign', () => {
  const [gain, loss] = [true, false].map((gains) => drawCoin({ text: '−5', gains }, { x: 0, y: 0 }, 0, 24))
  expect(middle(gain!).fill).not.toBe(middle(loss!).fill)
  expect(loss!.some((one) => one.kind === 'text' && one.text === '−5')).toBe(true)
})

test('a coin says tenths as the language writes them; what is less is no coin', () => {
  expect(coinFor(1.06, 'en')).toEqual({ text: '+1.1', gains: true })
  expect(coinFor(-5, 'de')).toEqual({ text: '−5,0', gains: false })
  expect([coinFor(0.049, 'en'), coinFor(0, 'en'), coinFor(-0.04, 'en')]).toEqual([null, null, null])
})
