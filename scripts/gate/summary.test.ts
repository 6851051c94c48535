import { expect, test, vi } from 'vitest'
import { isTooFlaky, summarize } from './summary.mjs'

const flaky = (name: string) => ({ name, failure: 'Bo stands.' })
const good = { passed: 4, failed: 0 }

/** Everything that was printed, and the exit code. */
function summaryOf(...[outcomes, earlier]: [Parameters<typeof summarize>[0], ReturnType<typeof flaky>[]?]) {
  const lines: string[] = []
  const printed = vi.spyOn(console, 'log').mockImplementation((line: string) => void lines.push(line))
  const folder = vi.fn()
  const code = summarize(outcomes, Date.now(), earlier, folder)
  printed.mockRestore()
  return { code, last: lines.at(-1), flaky: folder.mock.lastCall?.[0] as unknown }
}

test('the last line holds the counts alone', () => {
  expect(summaryOf([good, { passed: 1, failed: 2 }])).toMatchObject({ code: 1, last: '5 passed, 2 failed' })
})

test('one or two flaky tests are listed and do not fail a run', () => {
  const outcome = { ...good, flaky: [flaky('a'), flaky('b')] }
  const found = summaryOf([outcome])
  expect(found).toMatchObject({ code: 0, last: '4 passed, 0 failed' })
  expect(found.flaky).toEqual([flaky('a'), flaky('b')])
})

test('three flaky tests fail a run, those of other shards among them', () => {
  const outcome = { ...good, flaky: [flaky('a')] }
  expect(summaryOf([outcome], [flaky('b'), flaky('c')])).toMatchObject({
    code: 1,
    last: '4 passed, 1 failed',
  })
})

test('a flaky test that two shards report counts once', () => {
  expect(summaryOf([{ ...good, flaky: [flaky('a')] }], [flaky('a'), flaky('b')])).toMatchObject({ code: 0 })
  expect([isTooFlaky([flaky('a'), flaky('b')]), isTooFlaky([flaky('a'), flaky('b'), flaky('c')])]).toEqual([
    false,
    true,
  ])
})
