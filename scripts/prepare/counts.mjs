/** @typedef {{ passed: number, failed: number }} Count */

/** A step without tests of its own. @param {boolean} failed @returns {Count} */
export const oneStep = (failed) => ({ passed: failed ? 0 : 1, failed: failed ? 1 : 0 })

// A skipped test has shown nothing: it counts as failed.

/**
 * @param {{ numTotalTests: number, numPassedTests: number, numFailedTestSuites: number }} report
 * @returns {Count}
 */
export function countOfVitest({ numTotalTests, numPassedTests, numFailedTestSuites }) {
  const failed = numTotalTests - numPassedTests
  return { passed: numPassedTests, failed: Math.max(failed, Math.min(1, numFailedTestSuites)) }
}

/**
 * @param {{ stats: { expected: number, unexpected: number, flaky: number, skipped: number }, errors: unknown[] }} report
 * @returns {Count}
 */
export function countOfPlaywright({ stats, errors }) {
  return { passed: stats.expected, failed: stats.unexpected + stats.flaky + stats.skipped + errors.length }
}
