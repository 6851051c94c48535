import { sql } from 'kysely'
import type { Database } from '../database/database.ts'
import { migrate } from '../database/migrate.ts'

const pupils = 25
const versions = 20

/** A school network's PostgreSQL after half a year: classes of 25 with a project of 20 short versions each. */
export async function fillClasses(database: Database, classes: number): Promise<void> {
  await migrate(database)
  const statements = [
    sql`insert into teacher (id, name, email, "emailVerified", "createdAt", "updatedAt")
        values ('many', 'many', 'many@class.invalid', false, now(), now())`,
    sql`insert into class (id, teacher, name, language, grade, code, "joiningUntil", "closedAt", "endsOn", space, "madeAt")
        select 'c' || c, 'many', 'Class ' || c, 'en', 5, 'many-' || c, 0, 0, '2099-07-31', 0, 0
        from generate_series(1, ${classes}::int) c`,
    sql`insert into pupil (id, class, nickname, "nicknameKey", pictures, wrong, "isNew", "joinedAt")
        select 'p' || c || '-' || p, 'c' || c, 'Kind ' || p, 'kind ' || p, '', 0, 0, 0
        from generate_series(1, ${classes}::int) c, generate_series(1, ${pupils}::int) p`,
    sql`insert into project (pupil, id, class, revision, name, "savedAt")
        select id, 'project-1', class, ${versions}::int, 'Garden', 0 from pupil where class like 'c%'`,
    sql`insert into version (pupil, project, revision, class, "savedAt", bytes, hash, document)
        select pupil, id, revision_, class, revision_, 2, md5(pupil || revision_), '{}'
        from project, generate_series(1, ${versions}::int) revision_ where project.name = 'Garden'`,
    sql`analyze`,
  ]
  for (const statement of statements) await statement.execute(database.db)
}
