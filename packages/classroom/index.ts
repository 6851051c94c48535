// The class server as Request → Response. It knows the program's parser and the content, and nothing of the lab.
export { base, handle } from './handle.ts'
export { migrate, needsMigration, NewerData } from './database/migrate.ts'
export { openPostgres } from './database/postgres.ts'
export { openSqlite } from './database/sqlite.ts'
export type { Database } from './database/database.ts'
export type {
  Caller,
  CardOfClass,
  Finding,
  Host,
  LogLine,
  Ports,
  Questionnaires,
  RehearsalOutcome,
  RehearsalProgress,
  RehearsalWish,
  Tombstone,
} from './ports.ts'
export { dropAnswers } from './database/answers/postgres.ts'
export { checkInWorker } from './projects/check-in-worker.ts'
export { saveQueueOn } from './projects/save-queue.ts'
export { noBus, type Bus, type Message } from './live/bus.ts'
export { Hub } from './live/hub.ts'
export { Limits } from './limits.ts'
export { accountsOn, type Accounts } from './teaching/accounts.ts'
export { carryOut } from './teaching/deleting-store.ts'
export { firstTeacherToken, hasTeacher } from './teaching/first-teacher.ts'
export { endClasses, everyNight } from './teaching/every-night.ts'
export { clockDoubted } from './teaching/running-days-store.ts'
export {
  backup,
  lastBackup,
  nightliesIn,
  nightlyBackup,
  type Nightly,
  type Stored,
} from './hosting/backups.ts'
export { daysOfCopies, otherCopiesIn, pruneCopies, renewCopies } from './hosting/copies.ts'
export { markPhraseShown, phraseFrom, phraseOf, phraseShown } from './hosting/phrase-store.ts'
export { isKeyOf } from './hosting/key-store.ts'
export { openLock } from './hosting/lock.ts'
export { openDataFolder, secretIn } from './hosting/data-folder.ts'
export { fillReserve, useReserve } from './hosting/reserve.ts'
export { restore } from './hosting/restore.ts'
export { steadyClockOn, type SteadyClock } from './hosting/steady-clock-store.ts'
export { isSealed } from './hosting/sealed-file.ts'
export { bury, buriedIn } from './hosting/tombstones.ts'
