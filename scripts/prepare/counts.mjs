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

/** @typedef {{ title: string, specs?: readonly Spec[], suites?: readonly Suite[] }} Suite */
/** @typedef {{ title: string, tests: readonly { status: string, results: readonly Result[] }[] }} Spec */
/** @typedef {{ attachments: readonly { name: string, path?: string }[] }} Result */

/**
 * Tests that failed, each with what its page held then, as files with the roles and names that were on it.
 * @param {{ suites: readonly Suite[] }} report
 * @returns {{ title: string, pages: readonly string[] }[]}
 */
export function failedIn({ suites }) {
  return suites.flatMap(function named({ title, specs = [], suites = [] }) {
    const own = specs.flatMap((spec) =>
      spec.tests
        .filter(({ status }) => status === 'unexpected' || status === 'flaky')
        .map(({ results }) => ({
          title: `${title} › ${spec.title}`,
          pages: results.flatMap(({ attachments }) =>
            attachments.flatMap(({ name, path }) => (name === 'error-context' && path ? [path] : [])),
          ),
        })),
    )
    return [...own, ...suites.flatMap(named)]
  })
}
