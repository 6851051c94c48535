import {
  beginNight,
  behave,
  judged,
  measuresOf,
  tableOf,
  tenths,
  ticksOf,
  type Behaviour,
} from '@botgarten/lab/trying'
import {
  bucketsOf,
  payFor,
  statesOf,
  type Sentence,
  type TableBrain,
  type Trial,
} from '@botgarten/learning/q-senses'
import type { Floor, World } from '@botgarten/simulation'
import { passes } from '../trying/trying.ts'
import type { CageRow, CageRows, Measured, SenseCage } from './types.ts'

/** Simulated minutes of trying before a robot is judged. */
export const minutes = 8
/** So long it is watched from each start. */
const seconds = 30

/** A world with its floor, the robot on each of the cage's starts. */
export interface Place {
  readonly worlds: readonly World[]
  readonly floor: Floor
}

/** Numbers of a behaviour, and what a pay gives for it. */
const measuredOf = (behaviour: Behaviour, pay: readonly Sentence[]): Measured => ({
  ...measuresOf(behaviour),
  pay: tenths(payFor(pay, behaviour.facts)),
})

/** What one robot has learned in a cage, and what it does then. */
export interface Learned {
  readonly table: TableBrain
  readonly measured: Measured
  readonly cheats: boolean
}

/** Each try begins at one of the cage's starts, by chance. */
const trialOf = ({ trial, starts }: SenseCage, seed: number): Trial => ({ ...trial, starts, seed })

export function learnIn(cage: SenseCage, { worlds, floor }: Place, seed: number): Learned {
  const night = beginNight(worlds[0]!, floor, trialOf(cage, seed))
  night.advance(ticksOf(minutes))
  const table = tableOf(night.state)
  const { measured, cheats } = watchedIn(cage, { worlds, floor }, table)
  return { table, measured, cheats }
}

/** What came of another pay. */
export interface Mended {
  readonly table: TableBrain
  /** After which whole minute it drives a minute from every start without a bump and without cheating; null: after none. */
  readonly minute: number | null
}

/** Learns in a cage with another pay, until it drives as is meant and does not cheat, or its minutes are over. Yields each minute that is over. */
export function* mending(
  cage: SenseCage,
  place: Place,
  pay: readonly Sentence[],
  seed: number,
): Generator<number, Mended> {
  const { worlds, floor } = place
  const night = beginNight(worlds[0]!, floor, { ...trialOf(cage, seed), pay })
  for (let minute = 1; minute <= minutes; minute++) {
    night.advance(ticksOf(minute) - night.state.total)
    const table = tableOf(night.state)
    if (passes(table, worlds, floor) && !watchedIn(cage, place, table).cheats) return { table, minute }
    yield minute
  }
  return { table: tableOf(night.state), minute: null }
}

/** After which minute the cage's own mend drives as is meant. */
export function mendedIn(cage: SenseCage, place: Place, seed: number): number | null {
  const tries = mending(cage, place, cage.mend, seed)
  for (;;) {
    const { done, value } = tries.next()
    if (done) return value.minute
  }
}

/** A table watched from every start of a cage. */
export function watchedIn(cage: SenseCage, { worlds, floor }: Place, table: TableBrain) {
  const { behaviour, watched } = behave(table, worlds, floor, seconds)
  const measured = measuredOf(behaviour, table.pay)
  return { measured, watched, cheats: judged(cage.cheats, measured) }
}

/** A table as an honest program has it: ahead, and away from what is nearer than the far edge. */
export function honestBy(trial: Omit<Trial, 'seed'>): TableBrain {
  const states = statesOf(trial)
  const best = Array.from({ length: states }, (_, state) => honestAction(bucketsOf(trial, state)))
  return {
    ...{ ...trial, seed: 0, kind: 'table', moves: 0 },
    q: best.flatMap((action) => trial.actions.map((_, other) => Number(other === action))),
    tries: best.flatMap(() => trial.actions.map(() => 0)),
  }
}

const honestIn = ({ trial }: SenseCage, { worlds, floor }: Place): Measured | null =>
  trial.sensors.every(({ mode }) => mode === 'distance')
    ? measuredOf(behave(honestBy(trial), worlds, floor, seconds).behaviour, trial.pay)
    : null

/** Of ahead, left and right, the first three actions. Null: it touches. */
function honestAction(buckets: readonly number[] | null): 0 | 1 | 2 {
  if (buckets === null) return 1
  const [left = 2, right = 2] = buckets
  if (Math.min(left, right) >= 2) return 0
  return left < right ? 2 : 1
}

/** Learns with so many seeds from 1 on, with the cage's pay and with the mended one. */
export function rowsOf(cage: SenseCage, place: Place, seeds: number): CageRows {
  const all = Array.from({ length: seeds }, (_, k) => ({ seed: k + 1, ...learnIn(cage, place, k + 1) }))
  const bos = all.map(({ seed, cheats, measured }): CageRow => ({
    ...{ seed, cheats, ...measured },
    mended: mendedIn(cage, place, seed),
  }))
  const shown = all.find(({ cheats }) => cheats) ?? all[0]!
  const { q, tries, moves } = shown.table
  return {
    ...{ minutes, honest: honestIn(cage, place), bos },
    shown: { seed: shown.seed, q, tries, moves },
  }
}

/** How many of them cheat. */
export const countOf = (bos: CageRows['bos']): number => bos.filter(({ cheats }) => cheats).length

/** At least half of them cheat; what fewer do is a riddle. */
export const isCage = (bos: CageRows['bos']): boolean => 2 * countOf(bos) >= bos.length

/** The table of the robot that is watched. */
export const shownIn = (cage: SenseCage, { shown }: Pick<CageRows, 'shown'>): TableBrain => ({
  ...{ ...trialOf(cage, shown.seed), kind: 'table', moves: shown.moves },
  ...{ q: [...shown.q], tries: [...shown.tries] },
})
