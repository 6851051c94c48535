import { expect, test } from 'vitest'
import { countOfPlaywright, countOfVitest, failedIn, oneStep } from './counts.mjs'

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

test('skipped and flaky browser tests and errors outside of tests count as failed', () => {
  const stats = { expected: 7, unexpected: 1, flaky: 2, skipped: 3 }
  expect(countOfPlaywright({ stats, errors: [new Error('no browser')] })).toEqual({ passed: 7, failed: 7 })
})

test('a browser test that failed is named, with what its page held', () => {
  const page = { name: 'error-context', path: 'a.md' }
  const failed = {
    status: 'unexpected',
    results: [{ attachments: [{ name: 'screenshot', path: 'a.png' }, page] }],
  }
  const passed = { status: 'expected', results: [{ attachments: [] }] }
  const inside = {
    title: 'in de',
    specs: [
      { title: 'drives', tests: [failed] },
      { title: 'stops', tests: [passed] },
    ],
  }
  expect(failedIn({ suites: [{ title: 'x.spec.ts', suites: [inside] }] })).toEqual([
    { title: 'in de › drives', pages: ['a.md'] },
  ])
})
