import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { Fingers } from './keys.ts'

beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] }))
afterEach(() => void vi.useRealTimers())

function fingers() {
  const told: string[] = []
  return { told, hand: new Fingers((key, down) => told.push(`${key} ${down ? 'down' : 'up'}`)) }
}

describe('a finger on a key of the panel', () => {
  it('presses it once and lets it go', () => {
    const { told, hand } = fingers()
    hand.down('enter')
    hand.down('enter')
    vi.advanceTimersByTime(500)
    expect(told).toEqual(['enter down'])
    hand.up('enter')
    hand.up('enter')
    expect(told).toEqual(['enter down', 'enter up'])
  })

  it('presses for at least 120 ms, so that the program sees a quick tap', () => {
    const { told, hand } = fingers()
    hand.down('up')
    hand.up('up')
    vi.advanceTimersByTime(119)
    expect(told).toEqual(['up down'])
    vi.advanceTimersByTime(1)
    expect(told).toEqual(['up down', 'up up'])
  })

  it('that taps again meanwhile keeps it down', () => {
    const { told, hand } = fingers()
    hand.down('up')
    hand.up('up')
    vi.advanceTimersByTime(60)
    hand.down('up')
    vi.advanceTimersByTime(200)
    expect(told).toEqual(['up down'])
    hand.up('up')
    expect(told).toEqual(['up down', 'up up'])
  })

  it('lets everything go when the panel goes away', () => {
    const { told, hand } = fingers()
    hand.down('left')
    hand.down('right')
    hand.upAll()
    expect(told.slice(2).sort()).toEqual(['left up', 'right up'])
  })
})
