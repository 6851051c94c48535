import { keyedHash, sameHash } from '../hashes.ts'
import type { Ports } from '../ports.ts'
import { Refusal, WrongTry } from '../refusal.ts'
import { mostOpenings, pauseAfter, triesAfter } from './picture-limits.ts'
import { hasLocked, lockNickname, openNicknames } from './pupils-store.ts'
import { countAfter, countTry, forgetTries, putBack, triesOf, tryMemory, uncountTry } from './tries-store.ts'

/** Only a keyed hash of the pictures is stored, from which they cannot be read, not even by the teacher. */
export const hashOfPictures = ({ secret }: Ports, pupil: string, shown: readonly string[]) =>
  keyedHash(secret, 'pictures of', pupil, ...shown)

interface Owner {
  readonly id: string
  readonly pictures: string
}

interface Nickname {
  readonly class: string
  /** As it is compared. */
  readonly key: string
}

const nicknameOf = ({ secret }: Ports, { class: classId, key }: Nickname) =>
  keyedHash(secret, 'nickname', classId, key)
const openingsOf = ({ secret }: Ports, classId: string) => keyedHash(secret, 'opened', classId)

/**
 * Pictures from a device that is not the pupil's own. A nickname that exists and one that does not are counted alike.
 * @param owner undefined if no pupil has this nickname
 * @throws WrongTry 403 `wrongPictures`, 423 `nicknameLocked` once other devices were wrong too often
 */
export async function tryFromElsewhere(
  ports: Ports,
  nickname: Nickname,
  { owner, shown }: { readonly owner: Owner | undefined; readonly shown: readonly string[] },
): Promise<void> {
  const { db } = ports.database
  const [now, key] = [ports.now(), nicknameOf(ports, nickname)]
  const openings = await triesOf(db, openingsOf(ports, nickname.class), now)
  const most = triesAfter(openings?.count ?? 0)
  // Counted before it is compared: many requests at once are compared no more often than one after the other.
  const count = await countTry(db, key, now, most)
  if (count === null) throw new WrongTry(423, 'nicknameLocked')
  const isRight = sameHash(hashOfPictures(ports, owner?.id ?? '', shown), owner?.pictures ?? '')
  if (isRight) return await uncountTry(db, key)
  if (count === most) await lockNickname(db, nickname, now)
  throw new WrongTry(403, 'wrongPictures')
}

/**
 * Pictures on the pupil's own device: tries of others never lock it.
 * @param session by which the device is known as the pupil's
 * @throws WrongTry 403 `wrongPictures`; Refusal 429 after wrong tries of its own
 */
export async function tryOnOwnDevice(
  ports: Ports,
  session: string,
  { owner, shown }: { readonly owner: Owner; readonly shown: readonly string[] },
): Promise<void> {
  const { db } = ports.database
  const [now, key] = [ports.now(), keyedHash(ports.secret, 'own device', session)]
  const seen = await triesOf(db, key, now)
  const wait = seen ? seen.endsAt - tryMemory + pauseAfter(seen.count) - now : 0
  if (wait > 0) throw new Refusal(429, 'tooManyTries', { seconds: Math.ceil(wait / 1000) })
  if (!(await countAfter(db, key, seen, now))) throw new Refusal(429, 'tooManyTries', { seconds: 1 })
  if (!sameHash(hashOfPictures(ports, owner.id, shown), owner.pictures))
    throw new WrongTry(403, 'wrongPictures')
  await putBack(db, key, seen)
}

/** Opens the locks of all nicknames of a class. @returns whether it did: beyond five times a day only new pictures help */
export async function openLocks(ports: Ports, classId: string): Promise<boolean> {
  const { db } = ports.database
  const now = ports.now()
  if (!(await hasLocked(db, classId, now))) return true
  if ((await countTry(db, openingsOf(ports, classId), now, mostOpenings)) === null) return false
  await openNicknames(db, classId)
  return true
}

/** The pupil has new pictures: earlier tries are of no use for these. */
export const forgetTriesAt = (ports: Ports, nickname: Nickname): Promise<void> =>
  forgetTries(ports.database.db, nicknameOf(ports, nickname))
