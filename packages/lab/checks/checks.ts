import type { Check, CheckResult, Missing } from '../types.ts'
import type { AnyKind } from './kind.ts'
import { kinds } from './kinds.ts'
import type { Moment } from './moment.ts'
import type { Seen } from './seen.ts'

/** One check under way. Plain data, so that a keyframe holds it. */
export interface Watch {
  memory: unknown
  passed: boolean
  /** Second at which it passed last. */
  at: number | null
}

/** @throws RangeError for a kind that does not exist. */
export const watch = (checks: readonly Check[]): Watch[] =>
  checks.map((check) => ({ memory: kindOf(check).begin(), passed: false, at: null }))

function kindOf(check: Check): AnyKind {
  const kind = Object.hasOwn(kinds, check.kind) ? kinds[check.kind] : undefined
  if (!kind) throw new RangeError(`No check "${check.kind}".`)
  return kind
}

const momentOf = (
  checks: readonly Check[],
  watches: readonly Watch[],
  seconds: number,
  seen: Seen,
): Moment => ({
  ...seen,
  seconds,
  simulation: seen.state,
  passed: (id) => watches[checks.findIndex((check) => check.id === id)]?.passed ?? false,
})

/** Every check looks at one tick. */
export function observe(checks: readonly Check[], watches: Watch[], seconds: number, seen: Seen): void {
  const moment = momentOf(checks, watches, seconds, seen)
  checks.forEach((check, index) => {
    const kept = watches[index]!
    const passes = kindOf(check).observe(check, moment, kept.memory as never)
    if (passes && !kept.passed) kept.at = seconds
    if (!passes) kept.at = null
    kept.passed = passes
  })
}

export const results = (checks: readonly Check[], watches: readonly Watch[]): CheckResult[] =>
  checks.map(({ id }, index) => ({ id, passed: watches[index]!.passed, at: watches[index]!.at }))

/** What the open checks lack after `seconds`, in their order; first what was broken, for nothing after it counts. */
export function missing(
  checks: readonly Check[],
  watches: readonly Watch[],
  seconds: number,
  seen: Seen,
): readonly Missing[] {
  const moment = momentOf(checks, watches, seconds, seen)
  const open = checks.flatMap((check, index): readonly Missing[] => {
    const { passed, memory } = watches[index]!
    if (passed) return []
    const lack = kindOf(check).missing(check, memory as never, moment)
    return [{ check: check.id, kind: check.kind, ...lack }]
  })
  return [...open.filter(({ broken }) => broken), ...open.filter(({ broken }) => !broken)]
}
