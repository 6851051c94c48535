import { newToken } from '../hashes.ts'
import type { Ports } from '../ports.ts'
import { addInvitation, firstTeacher } from './operators-store.ts'

const lifetime = 30 * 60_000

/** The secret of a link that makes the first teacher, once, within 30 minutes; null where there is one already. */
export async function firstTeacherToken(
  ports: Pick<Ports, 'database' | 'steady' | 'random'>,
): Promise<string | null> {
  const { db } = ports.database
  if (await firstTeacher(db)) return null
  const token = newToken(ports.random)
  await addInvitation(db, token, 1, ports.steady() + lifetime)
  return token
}

/** Has somebody made this server theirs? */
export const hasTeacher = async ({ database }: Pick<Ports, 'database'>): Promise<boolean> =>
  (await firstTeacher(database.db)) !== undefined
