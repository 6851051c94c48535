import type { Db } from '../database/database.ts'
import { hashOf, newToken } from '../hashes.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { refuseHidden } from '../teaching/ending-store.ts'

const lesson = 90 * 60_000

export interface Pupil {
  readonly id: string
  readonly class: string
  readonly nickname: string
  readonly session: string
  /** Has joined or shown the pictures within this lesson. */
  readonly fresh: boolean
}

/** @returns the token that the device keeps: the class, so that a class that ended can say so, and a secret. */
export async function startSession(
  db: Db,
  { now, steady, random }: Ports,
  pupil: { readonly id: string; readonly class: string },
): Promise<string> {
  const token = `${pupil.class}.${newToken(random)}`
  await db
    .insertInto('pupilSession')
    .values((row) => ({
      ...{ tokenHash: hashOf(token), pupil: pupil.id, class: pupil.class },
      ...{ provenAt: now(), provenSteady: steady() },
      lesson: row.selectFrom('class').select('lesson').where('id', '=', pupil.class),
    }))
    .execute()
  return token
}

/**
 * Whose session a token is; null where it is nobody's (any more).
 * @throws Refusal 410 where the class of the token was deleted, 423 where it has ended and is not deleted yet
 */
export async function readPupil(ports: Ports, token: string | null): Promise<Pupil | null> {
  const { database, now, steady } = ports
  const { db } = database
  if (token === null) return null
  const tokenHash = hashOf(token)
  const row = await db
    .selectFrom('pupilSession')
    .innerJoin('pupil', 'pupil.id', 'pupilSession.pupil')
    .innerJoin('class', 'class.id', 'pupilSession.class')
    .select([
      'pupil.id',
      'pupil.class',
      'pupil.nickname',
      'pupilSession.provenAt',
      'pupilSession.provenSteady',
    ])
    .select(['pupilSession.lesson as proven', 'class.lesson', 'class.endsOn'])
    .where('tokenHash', '=', tokenHash)
    .executeTakeFirst()
  if (!row) return await refuseEnded(db, token)
  await refuseHidden(ports, row)
  // Both clocks: one may have been set back, and the other one does not advance while the server is off.
  const isWithin =
    Math.abs(now() - row.provenAt) < lesson &&
    (row.provenSteady === null || steady() - row.provenSteady < lesson)
  const fresh = row.proven === row.lesson && isWithin
  return { id: row.id, class: row.class, nickname: row.nickname, session: tokenHash, fresh }
}

async function refuseEnded(db: Db, token: string): Promise<null> {
  const [id = ''] = token.split('.')
  const ended = await db
    .selectFrom('tombstone')
    .select('id')
    .where('id', '=', id)
    .where('kind', '=', 'class')
    .executeTakeFirst()
  if (ended) throw new Refusal(410, 'classEnded')
  return null
}

export async function endSession(db: Db, session: string): Promise<void> {
  await db.deleteFrom('pupilSession').where('tokenHash', '=', session).execute()
}

export async function proveSession({ database: { db }, now, steady }: Ports, session: string): Promise<void> {
  await db
    .updateTable('pupilSession')
    .set((row) => ({
      provenAt: now(),
      provenSteady: steady(),
      lesson: row.selectFrom('class').select('lesson').whereRef('class.id', '=', 'pupilSession.class'),
    }))
    .where('tokenHash', '=', session)
    .execute()
}

export async function endSessionsOfClass(db: Db, classId: string): Promise<void> {
  await db.deleteFrom('pupilSession').where('class', '=', classId).execute()
}

export async function endSessionsOf(db: Db, pupil: string): Promise<void> {
  await db.deleteFrom('pupilSession').where('pupil', '=', pupil).execute()
}
