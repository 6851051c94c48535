import { sql } from 'kysely'
import { expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import { migrate, migrations, NewerData, refuseNewer } from './migrate.ts'

test.each(['sqlite', 'postgres'] as const)(
  'the steps of a %s database are in the order of their names, in which they are taken',
  (kind) => {
    const names = Object.keys(migrations({ kind }))
    expect(names).toEqual(names.toSorted())
  },
)

onBothDatabases((fresh) => {
  test('data of a later version is refused before anything is changed', async () => {
    const database = await fresh()
    await refuseNewer(database)
    const step = { name: 'step-999-later', timestamp: new Date(0).toISOString() }
    await sql`insert into kysely_migration (name, timestamp) values (${step.name}, ${step.timestamp})`.execute(
      database.db,
    )
    await expect(migrate(database)).rejects.toThrow(NewerData)
  })
})
