import { beforeEach, expect, test } from 'vitest'
import { writing } from './database.ts'
import { daysOfUse } from './days.ts'
import { freshDevice, recordIn } from './testing/device.ts'

beforeEach(freshDevice)
const days = (day: string) => writing((transaction) => daysOfUse(transaction, Date.parse(`${day}T12:00Z`)))

test('every later day counts once; a clock that goes back counts none twice', async () => {
  for (const [day, count] of [
    ['2026-11-22', 1],
    ['2026-11-22', 1],
    ['2026-11-23', 2],
    ['2026-11-20', 2],
    ['2026-11-21', 3],
  ] as const)
    expect(await days(day)).toBe(count)
})

test.each([['x'], [-1], [1.5], [0], [undefined]])(
  'a count that is %j begins anew, on the same day too',
  async (count) => {
    await days('2026-11-22')
    await recordIn('days', 'used', { id: 'used', count, last: '2026-11-22' })
    expect(await days('2026-11-22')).toBe(1)
    expect(await days('2026-11-23')).toBe(2)
  },
)
