import type { Db } from '../database/database.ts'
import { afterAnswer, afterCheck, neverRun, type Clock, type RunningDays } from './running-days.ts'

const key = 'running days'
/** Until November 2026: how many days the server had run on, and the last of them. */
const oldKey = 'days'

const valueOf = async (db: Db, name: string) =>
  (await db.selectFrom('meta').select('value').where('key', '=', name).executeTakeFirst())?.value

async function runningDays(db: Db): Promise<RunningDays> {
  const value = await valueOf(db, key)
  if (value !== undefined) return JSON.parse(value) as RunningDays
  const [, last = null] = (await valueOf(db, oldKey))?.split(' ') ?? []
  return { ...neverRun, last }
}

/** Stores the next state. Nodes that do so at once take turns. */
async function change(db: Db, next: (state: RunningDays) => RunningDays): Promise<RunningDays> {
  const first = JSON.stringify(await runningDays(db))
  await db
    .insertInto('meta')
    .values({ key, value: first })
    .onConflict((conflict) => conflict.column('key').doNothing())
    .execute()
  for (;;) {
    const before = (await valueOf(db, key)) ?? first
    const state = next(JSON.parse(before) as RunningDays)
    const value = JSON.stringify(state)
    if (value === before) return state
    const { numUpdatedRows } = await db
      .updateTable('meta')
      .set({ value })
      .where('key', '=', key)
      .where('value', '=', before)
      .executeTakeFirst()
    if (numUpdatedRows > 0n) return state
  }
}

interface Clocked {
  readonly db: Db
  readonly clock: Clock
}

/** Notes that the server runs today. */
export const noteDay = ({ db, clock }: Clocked): Promise<RunningDays> =>
  change(db, (state) => afterCheck(state, clock))

/** Notes the answer of the operator on whether the clock is right. */
export const noteAnswer = ({ db, clock }: Clocked, isRight: boolean): Promise<RunningDays> =>
  change(db, (state) => afterAnswer(afterCheck(state, clock), clock, isRight))

/** The state with a check of the clock, which is not stored. */
export const daysNow = async ({ db, clock }: Clocked): Promise<RunningDays> =>
  afterCheck(await runningDays(db), clock)

/**
 * Does the clock need an answer of the operator, now that it shows this day? Until then nothing may be deleted because of a date.
 * @param clock the ISO day `offset` days after today, as `ports.day` gives it
 */
export const clockDoubted = async (db: Db, clock: Clock): Promise<boolean> =>
  (await daysNow({ db, clock })).doubt !== null
