import type { Kysely } from 'kysely'
import type { Kind } from './database.ts'

/** The first tables. Those of the teachers' accounts have the columns that better-auth asks for. */
export const first = (kind: Kind) => ({
  async up(db: Kysely<unknown>): Promise<void> {
    for (const table of [...accountTables(db, kind), ...classTables(db), ...projectTables(db)])
      await table.execute()
    for (const [table, columns] of indexes)
      await db.schema
        .createIndex(`${table}By${columns.join('')}`)
        .on(table)
        .columns([...columns])
        .execute()
  },
})

const indexes = [
  ['class', ['code']],
  ['class', ['teacher']],
  ['pupilSession', ['pupil']],
  ['teacherSession', ['userId']],
  ['account', ['userId']],
  ['version', ['class']],
  ['versionAsset', ['class', 'hash']],
] as const

function accountTables({ schema }: Kysely<unknown>, kind: Kind) {
  const moment = kind === 'postgres' ? 'timestamptz' : 'text'
  const yes = kind === 'postgres' ? 'boolean' : 'integer'
  return [
    schema
      .createTable('teacher')
      .addColumn('id', 'text', (column) => column.primaryKey())
      .addColumn('name', 'text', (column) => column.notNull())
      .addColumn('email', 'text', (column) => column.notNull().unique())
      .addColumn('emailVerified', yes, (column) => column.notNull())
      .addColumn('image', 'text')
      .addColumn('createdAt', moment, (column) => column.notNull())
      .addColumn('updatedAt', moment, (column) => column.notNull())
      .addColumn('username', 'text', (column) => column.unique())
      .addColumn('displayUsername', 'text'),
    schema
      .createTable('teacherSession')
      .addColumn('id', 'text', (column) => column.primaryKey())
      .addColumn('expiresAt', moment, (column) => column.notNull())
      .addColumn('token', 'text', (column) => column.notNull().unique())
      .addColumn('createdAt', moment, (column) => column.notNull())
      .addColumn('updatedAt', moment, (column) => column.notNull())
      .addColumn('ipAddress', 'text')
      .addColumn('userAgent', 'text')
      .addColumn('userId', 'text', (column) => column.notNull().references('teacher.id').onDelete('cascade')),
    schema
      .createTable('account')
      .addColumn('id', 'text', (column) => column.primaryKey())
      .addColumn('accountId', 'text', (column) => column.notNull())
      .addColumn('providerId', 'text', (column) => column.notNull())
      .addColumn('userId', 'text', (column) => column.notNull().references('teacher.id').onDelete('cascade'))
      .addColumn('accessToken', 'text')
      .addColumn('refreshToken', 'text')
      .addColumn('idToken', 'text')
      .addColumn('accessTokenExpiresAt', moment)
      .addColumn('refreshTokenExpiresAt', moment)
      .addColumn('scope', 'text')
      .addColumn('password', 'text')
      .addColumn('createdAt', moment, (column) => column.notNull())
      .addColumn('updatedAt', moment, (column) => column.notNull()),
    schema
      .createTable('verification')
      .addColumn('id', 'text', (column) => column.primaryKey())
      .addColumn('identifier', 'text', (column) => column.notNull())
      .addColumn('value', 'text', (column) => column.notNull())
      .addColumn('expiresAt', moment, (column) => column.notNull())
      .addColumn('createdAt', moment, (column) => column.notNull())
      .addColumn('updatedAt', moment, (column) => column.notNull()),
    schema
      .createTable('rateLimit')
      .addColumn('id', 'text', (column) => column.primaryKey())
      .addColumn('key', 'text', (column) => column.notNull().unique())
      .addColumn('count', 'integer', (column) => column.notNull())
      .addColumn('lastRequest', 'bigint', (column) => column.notNull()),
    schema
      .createTable('operator')
      .addColumn('teacher', 'text', (column) =>
        column.primaryKey().references('teacher.id').onDelete('cascade'),
      )
      .addColumn('madeAt', 'bigint', (column) => column.notNull()),
    schema
      .createTable('invitation')
      .addColumn('tokenHash', 'text', (column) => column.primaryKey())
      .addColumn('first', 'integer', (column) => column.notNull())
      .addColumn('endsAt', 'bigint', (column) => column.notNull()),
  ]
}

function classTables({ schema }: Kysely<unknown>) {
  return [
    schema
      .createTable('class')
      .addColumn('id', 'text', (column) => column.primaryKey())
      .addColumn('teacher', 'text', (column) => column.notNull().references('teacher.id'))
      .addColumn('name', 'text', (column) => column.notNull())
      .addColumn('language', 'text', (column) => column.notNull())
      .addColumn('grade', 'integer', (column) => column.notNull())
      .addColumn('code', 'text', (column) => column.notNull().unique())
      .addColumn('joiningUntil', 'bigint', (column) => column.notNull())
      .addColumn('openedAt', 'bigint')
      .addColumn('closedAt', 'bigint', (column) => column.notNull())
      .addColumn('endsOn', 'text', (column) => column.notNull())
      .addColumn('announcedDay', 'integer')
      .addColumn('space', 'bigint', (column) => column.notNull())
      .addColumn('madeAt', 'bigint', (column) => column.notNull()),
    schema
      .createTable('pupil')
      .addColumn('id', 'text', (column) => column.primaryKey())
      .addColumn('class', 'text', (column) => column.notNull().references('class.id').onDelete('cascade'))
      .addColumn('nickname', 'text', (column) => column.notNull())
      .addColumn('nicknameKey', 'text', (column) => column.notNull())
      .addColumn('pictures', 'text', (column) => column.notNull())
      .addColumn('wrong', 'integer', (column) => column.notNull())
      .addColumn('lockedAt', 'bigint')
      .addColumn('handAt', 'bigint')
      .addColumn('isNew', 'integer', (column) => column.notNull())
      .addColumn('joinedAt', 'bigint', (column) => column.notNull())
      .addUniqueConstraint('oneNicknameAClass', ['class', 'nicknameKey']),
    schema
      .createTable('pupilSession')
      .addColumn('tokenHash', 'text', (column) => column.primaryKey())
      .addColumn('pupil', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
      .addColumn('class', 'text', (column) => column.notNull())
      .addColumn('provenAt', 'bigint', (column) => column.notNull()),
    schema
      .createTable('attempt')
      .addColumn('key', 'text', (column) => column.primaryKey())
      .addColumn('count', 'integer', (column) => column.notNull())
      .addColumn('endsAt', 'bigint', (column) => column.notNull()),
    schema
      .createTable('meta')
      .addColumn('key', 'text', (column) => column.primaryKey())
      .addColumn('value', 'text', (column) => column.notNull()),
    schema
      .createTable('tombstone')
      .addColumn('id', 'text', (column) => column.primaryKey())
      .addColumn('kind', 'text', (column) => column.notNull()),
  ]
}

function projectTables({ schema }: Kysely<unknown>) {
  return [
    schema
      .createTable('project')
      .addColumn('pupil', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
      .addColumn('id', 'text', (column) => column.notNull())
      .addColumn('class', 'text', (column) => column.notNull())
      .addColumn('revision', 'integer', (column) => column.notNull())
      .addColumn('name', 'text', (column) => column.notNull())
      .addColumn('card', 'text')
      .addColumn('savedAt', 'bigint', (column) => column.notNull())
      .addPrimaryKeyConstraint('projectKey', ['pupil', 'id']),
    schema
      .createTable('version')
      .addColumn('pupil', 'text', (column) => column.notNull())
      .addColumn('project', 'text', (column) => column.notNull())
      .addColumn('revision', 'integer', (column) => column.notNull())
      .addColumn('class', 'text', (column) => column.notNull())
      .addColumn('savedAt', 'bigint', (column) => column.notNull())
      .addColumn('bytes', 'integer', (column) => column.notNull())
      .addColumn('hash', 'text', (column) => column.notNull())
      .addColumn('document', 'text', (column) => column.notNull())
      .addPrimaryKeyConstraint('versionKey', ['pupil', 'project', 'revision'])
      .addForeignKeyConstraint('versionOfProject', ['pupil', 'project'], 'project', ['pupil', 'id'], (key) =>
        key.onDelete('cascade'),
      ),
    schema
      .createTable('answered')
      .addColumn('pupil', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
      .addColumn('save', 'text', (column) => column.notNull())
      .addColumn('project', 'text', (column) => column.notNull())
      .addColumn('revision', 'integer', (column) => column.notNull())
      .addColumn('savedAt', 'bigint', (column) => column.notNull())
      .addPrimaryKeyConstraint('answeredKey', ['pupil', 'save']),
    schema
      .createTable('asset')
      .addColumn('class', 'text', (column) => column.notNull().references('class.id').onDelete('cascade'))
      .addColumn('hash', 'text', (column) => column.notNull())
      .addColumn('type', 'text', (column) => column.notNull())
      .addColumn('base64', 'text', (column) => column.notNull())
      .addPrimaryKeyConstraint('assetKey', ['class', 'hash']),
    schema
      .createTable('versionAsset')
      .addColumn('pupil', 'text', (column) => column.notNull())
      .addColumn('project', 'text', (column) => column.notNull())
      .addColumn('revision', 'integer', (column) => column.notNull())
      .addColumn('class', 'text', (column) => column.notNull())
      .addColumn('name', 'text', (column) => column.notNull())
      .addColumn('hash', 'text', (column) => column.notNull())
      .addPrimaryKeyConstraint('versionAssetKey', ['pupil', 'project', 'revision', 'name'])
      .addForeignKeyConstraint(
        'versionAssetOfVersion',
        ['pupil', 'project', 'revision'],
        'version',
        ['pupil', 'project', 'revision'],
        (key) => key.onDelete('cascade'),
      ),
  ]
}
