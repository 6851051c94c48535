import type { Db } from '../database/database.ts'

const key = 'steady clock'

/** Two clocks of the machine, in ms. `now` may be set at any time; `elapsed` never goes back and starts with each process. */
interface Clocks {
  readonly now: () => number
  readonly elapsed: () => number
}

/** For durations: it advances while a server of this database runs, and does not depend on the clock of the machine. */
export interface SteadyClock {
  /** In ms: comparable with stored times of this clock only, also after a restart and on other nodes. */
  readonly now: () => number
  /** Stores the time, so that it continues from here after a restart. Nodes of one database follow the one that is ahead. */
  readonly store: () => Promise<void>
}

async function stored(db: Db): Promise<number | null> {
  const row = await db.selectFrom('meta').select('value').where('key', '=', key).executeTakeFirst()
  return row ? Number(row.value) : null
}

/** Continues from the stored time. Durations of earlier versions end by the clock of the machine: it starts there. */
export async function steadyClockOn(db: Db, { now, elapsed }: Clocks): Promise<SteadyClock> {
  let base = ((await stored(db)) ?? now()) - elapsed()
  const steady = () => Math.floor(base + elapsed())
  async function store() {
    const others = await stored(db)
    if (others !== null && others > steady()) return void (base = others - elapsed())
    const value = String(steady())
    await db
      .insertInto('meta')
      .values({ key, value })
      .onConflict((conflict) => conflict.column('key').doUpdateSet({ value }))
      .execute()
  }
  return { now: steady, store }
}
