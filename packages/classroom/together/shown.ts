import type { Db } from '../database/database.ts'
import type { PairRow } from '../database/together-tables.ts'
import { nicknameOf, pairOf } from './pairs-store.ts'

export const otherOf = ({ inviter, invited }: PairRow, pupil: string) =>
  pupil === inviter ? invited : inviter

/** What a pupil's page knows of its pair. `me`: which of the two it is; `a` has invited. */
export async function shownPair(db: Db, pupil: string) {
  const pair = await pairOf(db, pupil)
  if (!pair) return null
  return {
    id: pair.id,
    title: pair.title,
    with: await nicknameOf(db, otherOf(pair, pupil)),
    me: pupil === pair.inviter ? ('a' as const) : ('b' as const),
    accepted: pair.accepted === 1,
    role: pupil === pair.hand ? ('hand' as const) : ('eye' as const),
    /** The other one has left. */
    over: pair.left !== null,
  }
}
