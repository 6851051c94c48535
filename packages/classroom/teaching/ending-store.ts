import type { Db } from '../database/database.ts'
import type { ClassRow } from '../database/tables.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { daysNow } from './running-days-store.ts'
import type { Clock } from './running-days.ts'

/** Teachers see the end of a class so many days before. */
const notice = 14

export const endsSoon = ({ endsOn }: Pick<ClassRow, 'endsOn'>, day: Clock): boolean => endsOn <= day(notice)

/** Ids of the classes whose last day is over by the clock. */
export async function endedClasses(db: Db, day: Clock): Promise<readonly string[]> {
  const rows = await db.selectFrom('class').select('id').where('endsOn', '<=', day(0)).execute()
  return rows.map(({ id }) => id)
}

/**
 * Is a class hidden from everyone? It is from the day on which it ends until it is deleted, unless the operator has answered
 * that the clock is wrong.
 */
export async function isHidden(
  { database: { db }, day }: Pick<Ports, 'database' | 'day'>,
  { endsOn }: Pick<ClassRow, 'endsOn'>,
): Promise<boolean> {
  return endsOn <= day(0) && (await daysNow({ db, clock: day })).doubt?.denied !== true
}

/** @throws Refusal 423 for a class that has ended and is not deleted yet: devices keep their work and try again */
export async function refuseHidden(
  ports: Pick<Ports, 'database' | 'day'>,
  row: Pick<ClassRow, 'endsOn'>,
): Promise<void> {
  if (await isHidden(ports, row)) throw new Refusal(423, 'classHidden')
}
