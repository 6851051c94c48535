import fc from 'fast-check'
import { expect, test } from 'vitest'
import { Refused } from './refused.ts'

/** As `performance.now()` gives it: ms with six digits after the point. */
const time = fc.integer({ min: 0, max: 1e12 }).map((ns) => ns / 1e6)

test('a device waits exactly as many seconds as it was refused for, whatever the fraction of the clock', () => {
  fc.assert(
    fc.property(time, fc.integer({ min: 1, max: 600 }), (at, seconds) => {
      let now = at
      const refused = new Refused(() => now)
      refused.note('device', seconds)
      expect(refused.secondsOf('device')).toBe(seconds)
      now = at + seconds * 1000 + 1
      expect(refused.secondsOf('device')).toBe(0)
      expect(refused.secondsOf('another')).toBe(0)
    }),
  )
})
