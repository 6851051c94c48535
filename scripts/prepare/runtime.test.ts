import { expect, test } from 'vitest'
import { isNewEnough } from './runtime.mjs'

test.each([['22.18.0'], ['22.19.1'], ['24.0.0'], ['100.1.0']])(
  'Node %s runs TypeScript by itself',
  (version) => {
    expect(isNewEnough(version)).toBe(true)
  },
)

test.each([['20.19.0'], ['22.17.9'], ['21.99.0'], ['8.30.0']])('Node %s does not', (version) => {
  expect(isNewEnough(version)).toBe(false)
})
