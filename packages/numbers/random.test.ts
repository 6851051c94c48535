import { expect, test } from 'vitest'
import { draw, fastDraw, fastStream, stream, type StreamState } from './index.ts'
import reference from './reference/streams.json' with { type: 'json' }

test.each(reference)('stream "$name" of seed $seed starts and draws as the published code does', (row) => {
  const state = stream(row.seed, row.name)
  expect(state).toEqual(row.state)
  expect(row.draws.map(() => draw(state))).toEqual(row.draws)
})

test("xoshiro128** gives what the authors' C program gave", () => {
  // First outputs for this state, printed by xoshiro128starstar.c: github.com/edorfaus/xoshiro-6502, test-rom/testdata.asm.
  const state: StreamState = [0x964d4a0c, 0xd40ab895, 0xad7fdecb, 0x3006f0f0]
  const joined = (upper: number, lower: number) => ((upper >>> 5) * 2 ** 26 + (lower >>> 6)) / 2 ** 53
  expect(draw(state)).toBe(joined(0xf1391922, 0x6fe53806))
  expect(state).toEqual([0xff3a011b, 0xb33a90fc, 0x2c5a18ae, 0xd81b946b])
  expect(draw(state)).toBe(joined(0xa5be2840, 0xf510ee70))
})

test('a copied state goes on with the same draws, through JSON as well', () => {
  const state = stream(7, 'noise')
  draw(state)
  const copy = JSON.parse(JSON.stringify(state)) as StreamState
  const draws = (of: StreamState) => Array.from({ length: 20 }, () => draw(of))
  expect(draws(copy)).toEqual(draws(state))
})

test('draws are spread evenly over [0, 1)', () => {
  const state = stream(1, 'evenness')
  const bins = new Array<number>(16).fill(0)
  for (let i = 0; i < 16000; i++) bins[Math.floor(draw(state) * 16)]!++
  // Chi square with 15 degrees of freedom passes 37.7 once in a thousand seeds; this one is fixed.
  expect(bins.reduce((sum, n) => sum + (n - 1000) ** 2 / 1000, 0)).toBeLessThan(37.7)
})

test('a fast stream gives the upper word of every output of the plain one', () => {
  const state = stream(3, 'learn/a/1')
  const fast = fastStream(state)
  for (let pair = 0; pair < 1000; pair++) {
    const upper = Math.floor(fastDraw(fast) * 2 ** 27)
    const lower = Math.floor(fastDraw(fast) * 2 ** 26)
    expect(draw(state)).toBe((upper * 2 ** 26 + lower) / 2 ** 53)
  }
  expect([...fast]).toEqual(state)
})
