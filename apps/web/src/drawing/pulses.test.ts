import { describe, expect, test } from 'vitest'
import { pulseRate } from './pulses.ts'

describe('pulses', () => {
  test('take 900 ms at 50 and 500 ms at 100, and at most 1600 ms', () => {
    expect(pulseRate(50).milliseconds).toBe(900)
    expect(pulseRate(100).milliseconds).toBe(500)
    expect(pulseRate(1).milliseconds).toBeLessThanOrEqual(1600)
    expect(pulseRate(300)).toEqual(pulseRate(100))
  })

  test('stop where there is no signal, and are never more than 8', () => {
    expect(pulseRate(0).count).toBe(0)
    expect([2, 20, 50, 80].map((signal) => pulseRate(signal).count)).toEqual([1, 2, 4, 8])
  })

  test('a trembling value changes nothing', () => {
    expect(pulseRate(54)).toEqual(pulseRate(55.4))
  })
})
