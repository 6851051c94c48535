import { beforeAll, beforeEach, expect, test } from 'vitest'
import type { Database } from '../database/database.ts'
import { onBothDatabases } from '../testing/databases.ts'
import { teacherOn } from '../testing/teacher.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { steadyClockOn } from './steady-clock-store.ts'

const [minute, hour, day, year] = [60_000, 3_600_000, 86_400_000, 365 * 86_400_000]
const start = Date.UTC(2026, 10, 24, 8)

/** A machine with a clock that may be set, and one that starts with each process. */
class Machine {
  set = start
  private since = 0
  private at = 0
  readonly now = () => this.set
  readonly elapsed = () => this.at - this.since
  passes(ms: number) {
    this.set += ms
    this.at += ms
  }
  restarts(off: number) {
    this.passes(off)
    this.since = this.at
  }
}

const jumps = [hour, day, year].flatMap((jump) => [jump, -jump])

onBothDatabases((fresh) => {
  let database: Database
  let db: Database['db']
  beforeAll(async () => {
    database = await fresh()
    db = database.db
  })
  beforeEach(async () => {
    await db.deleteFrom('meta').where('key', '=', 'steady clock').execute()
  })

  test.each(jumps)('a clock that is set by %i ms changes no duration', async (jump) => {
    const machine = new Machine()
    const clock = await steadyClockOn(db, machine)
    const began = clock.now()
    machine.set += jump
    machine.passes(10 * minute)
    expect(clock.now() - began).toBe(10 * minute)
  })

  test.each(jumps)(
    'after a restart with a clock that was set by %i ms it continues from its last time',
    async (jump) => {
      const machine = new Machine()
      const clock = await steadyClockOn(db, machine)
      machine.passes(10 * minute)
      await clock.store()
      const stopped = clock.now()
      machine.set += jump
      machine.restarts(3 * hour)
      const next = await steadyClockOn(db, machine)
      expect(next.now()).toBe(stopped)
      machine.passes(minute)
      expect(next.now() - stopped).toBe(minute)
    },
  )

  test('durations of earlier versions end by the clock of the machine: it starts there', async () => {
    expect((await steadyClockOn(db, new Machine())).now()).toBe(start)
  })

  test('nodes of one database follow the one that is ahead, and none goes back', async () => {
    const [one, other] = [new Machine(), new Machine()]
    const first = await steadyClockOn(db, one)
    one.passes(10 * minute)
    await first.store()
    const second = await steadyClockOn(db, other)
    one.passes(30_000)
    other.passes(50_000)
    await first.store()
    await second.store()
    await first.store()
    expect(first.now()).toBe(start + 10 * minute + 50_000)
    expect(second.now()).toBe(first.now())
  })

  test.each(jumps)(
    'after a restart with a clock that was set by %i ms a code works for the rest of its 20 minutes',
    async (jump) => {
      const machine = new Machine()
      const open = async () => {
        const clock = await steadyClockOn(database.db, machine)
        const server = new Server(database, { steady: clock.now, ...quickAccounts(database) })
        return { clock, server }
      }
      const before = await open()
      const teacher = await teacherOn(before.server)
      const { id, code } = await before.server.openClass(teacher)
      await teacher.patch(`/classes/${id}`, { endsOn: '2029-12-31' })
      machine.passes(15 * minute)
      await before.clock.store()
      machine.set += jump
      machine.restarts(2 * minute)
      const { server } = await open()
      server.now = machine.now()
      const look = async () => (await server.browser().post('/look', { code })).status
      machine.passes(4 * minute)
      expect(await look()).toBe(200)
      machine.passes(2 * minute)
      expect(await look()).toBe(404)
    },
  )
})
