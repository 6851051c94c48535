import { expect, test } from 'vitest'
import { ago } from './ago.ts'

const now = Date.UTC(2026, 10, 21, 12)

test('the last save is told in the largest whole unit', () => {
  expect(ago(now - 2 * 60_000, now, 'en')).toBe('2 minutes ago')
  expect(ago(now - 3 * 3_600_000 - 59 * 60_000, now, 'de')).toBe('vor 3 Stunden')
  expect(ago(now - 86_400_000, now, 'de')).toBe('gestern')
})

test('a clock that was set back does not tell the future', () => {
  expect(ago(now + 5000, now, 'en')).toBe('now')
})
