import type { SimulationState, World } from '@botgarten/simulation'
import type { Check, CheckResult } from '../types.ts'
import type { AnyKind } from './kind.ts'
import { kinds } from './kinds.ts'

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
  world: World,
  simulation: SimulationState,
): void {
  const passed = (id: string) => watches[checks.findIndex((check) => check.id === id)]?.passed ?? false
  const moment = { seconds, world, simulation, passed }
  checks.forEach((check, index) => {
    const state = watches[index]!
    const passes = kindOf(check).observe(check, moment, state.memory as never)
    if (passes && !state.passed) state.at = seconds
    if (!passes) state.at = null
    state.passed = passes
  })
}

export const results = (checks: readonly Check[], watches: readonly Watch[]): CheckResult[] =>
  checks.map(({ id }, index) => ({ id, passed: watches[index]!.passed, at: watches[index]!.at }))
