import { expect, test } from 'vitest'
import { countOfPlaywright, countOfVitest, oneStep, unsteady } from './counts.mjs'

test('a step without tests counts as one', () => {
  expect(oneStep(false)).toEqual({ passed: 1, failed: 0 })
  expect(oneStep(true)).toEqual({ passed: 0, failed: 1 })
})

test('a skipped unit test counts as failed', () => {
  const report = { numTotalTests: 5, numPassedTests: 4, numFailedTestSuites: 0 }
  expect(countOfVitest(report)).toEqual({ passed: 4, failed: 1 })
})

test('a test file that could not be loaded counts as failed', () => {
  const report = { numTotalTests: 4, numPassedTests: 4, numFailedTestSuites: 2 }
  expect(countOfVitest(report)).toEqual({ passed: 4, failed: 1 })
})

test('skipped browser tests and errors outside of tests count as failed, a second try that passed does not', () => {
  const stats = { expected: 7, unexpected: 1, flaky: 2, skipped: 3 }
  expect(countOfPlaywright({ stats, errors: [new Error('no browser')] })).toEqual({ passed: 9, failed: 5 })
})

test('a test that did not pass at once is named, with what its page held', () => {
  const failing = {
    attachments: [
      { name: 'screenshot', path: 'a.png' },
      { name: 'error-context', path: 'a.md' },
    ],
  }
  const good = { attachments: [] }
  const spec = (
    title: string,
    status: string,
    ...results: { attachments: { name: string; path?: string }[] }[]
  ) => ({
    title,
    file: 'x.spec.ts',
    tests: [{ status, results }],
  })
  const inside = {
    title: 'in de',
    specs: [spec('drives', 'flaky', failing, good), spec('stops', 'expected', good)],
  }
  const suites = [
    { title: 'x.spec.ts', specs: [spec('turns', 'unexpected', failing, failing)], suites: [inside] },
  ]
  expect(unsteady({ suites })).toEqual([
    { title: 'x.spec.ts › turns', passed: false, pages: ['a.md', 'a.md'] },
    { title: 'in de › drives', passed: true, pages: ['a.md'] },
  ])
})
