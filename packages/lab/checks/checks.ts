import type { Simulation } from '@botgarten/simulation'
import type { Check, CheckResult } from '../types.ts'
import type { AnyKind } from './kind.ts'
import { kinds } from './kinds.ts'
import type { Moment } from './moment.ts'

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
  if (!kind) throw new RangeError(`No kind of check is called "${check.kind}".`)
  return kind
}

/** Every check looks at one tick. */
export function observe(
  checks: readonly Check[],
  watches: Watch[],
  seconds: number,
  { world, state, read }: Pick<Simulation, 'world' | 'state' | 'read'>,
  nextTurn: Moment['nextTurn'] = () => null,
): void {
  const passed = (id: string) => watches[checks.findIndex((check) => check.id === id)]?.passed ?? false
  const moment: Moment = { seconds, world, simulation: state, read, nextTurn, passed }
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
