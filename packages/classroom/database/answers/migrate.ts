import { Migrator } from 'kysely'
import type { AnswersDatabase } from './database.ts'
import { first } from './first.ts'
import { tokens } from './tokens.ts'

/** Takes the steps that the tables of answers miss, forward only. @throws the error of the step that failed */
export async function migrateAnswers({ db, schema }: AnswersDatabase): Promise<void> {
  const place = await schema()
  const migrations = {
    '2026-11-first': first(place === null),
    'step-002-tokens': tokens(place === null),
  }
  const migrator = new Migrator({
    db,
    // Under names of their own: the lab's migrator looks for its tables in all schemas.
    ...{ migrationTableName: 'answersMigration', migrationLockTableName: 'answersMigrationLock' },
    provider: { getMigrations: () => Promise.resolve(migrations) },
    ...(place === null ? {} : { migrationTableSchema: place }),
  })
  const { error } = await migrator.migrateToLatest()
  if (error !== undefined) throw error instanceof Error ? error : new Error('A migration failed.')
}
