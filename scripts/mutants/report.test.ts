import { expect, test } from 'vitest'
import { reachesGoals, reportOf, shareOf, type Outcome, type RoomReport } from './report.ts'
import type { Group } from './rooms.ts'

const mutant = { file: 'a.ts', line: 3, was: 'a', change: '`x` → nothing', text: '' }
const reportFor = (name: string, outcomes: readonly Outcome[], group: Group = 'other'): RoomReport => ({
  ...{ room: { name, group }, among: 90, drawn: 4, equivalent: 1 },
  tried: outcomes.map((outcome) => ({ mutant, outcome })),
})
const times = (count: number, outcome: Outcome) => Array.from({ length: count }, () => outcome)

test('a report counts what was found, and names what was not', () => {
  const text = reportOf([reportFor('maps', ['killed', 'timeout', 'survived', 'unasked'])], 7)
  expect(text).toContain('| maps | 2 of 4 | 50 % | 90 | 1 |')
  expect(text).toContain('| all others | 2 of 4 | 50 % | 80 % |')
  expect(text).toContain('seed 7')
  expect(text).toContain("- `a.ts:3`: `'x' → nothing`\n- `a.ts:3`: `'x' → nothing` (no test imports it)\n")
  expect(text).not.toContain('Not run')
})

test('a room that was not run, or not to its end, is named and not counted as good', () => {
  const text = reportOf([reportFor('maps', ['killed']), reportFor('blocks', [])], 1)
  expect(text).toContain('## Not run, or not to the end\n\n- maps: 1 of 4\n- blocks: 0 of 4\n')
  expect(text).not.toContain('| blocks |')
})

test('rooms count together: 80 % of all mutants, 95 % of those of storage and classroom', () => {
  const good = reportFor('maps', times(60, 'killed'))
  const poor = reportFor('blocks', [...times(20, 'killed'), ...times(20, 'survived')])
  expect([shareOf([good, poor], 'other'), shareOf([good, poor], 'saved')]).toEqual([0.8, null])
  expect(reachesGoals([good, poor])).toBe(true)
  expect(reachesGoals([good, poor, reportFor('more', ['survived'])])).toBe(false)
  const saved = (survived: number) =>
    reportFor('storage', [...times(100 - survived, 'killed'), ...times(survived, 'survived')], 'saved')
  expect([reachesGoals([good, saved(5)]), reachesGoals([good, saved(6)])]).toEqual([true, false])
})
