import { afterEach, expect, test, vi } from 'vitest'
import { keepAnswers, readAnswers } from './results.ts'

const kept = new Map<string, string>()
vi.stubGlobal('localStorage', {
  getItem: (key: string) => kept.get(key) ?? null,
  setItem: (key: string, value: string) => kept.set(key, value),
})
afterEach(() => kept.clear())

test('what is answered is kept by module, before and after apart', () => {
  keepAnswers(2, 'before', { 'all-zero': 'stands' })
  expect(readAnswers(2, 'before')).toEqual({ 'all-zero': 'stands' })
  expect([readAnswers(2, 'after'), readAnswers(3, 'before')]).toEqual([{}, {}])
})

test.each(['not json', '"words"', 'null', '{"all-zero":5}', '[1]'])('%s is no answer', (text) => {
  kept.set('botgarten.questions-1-before', text)
  expect(readAnswers(1, 'before')).toEqual({})
})
