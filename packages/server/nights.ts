import {
  clockDoubted,
  daysOfCopies,
  endClasses,
  everyNight,
  fillReserve,
  hasTeacher,
  pruneCopies,
  renewCopies,
  type Ports,
} from '@botgarten/classroom'
import { causeIn } from './problem.ts'

const every = 60_000
/** After a failure: a full disk may have room by then. */
const pause = 10 * 60_000
const quietFrom = 2

/** A backup of today where there is none yet, and the end of old copies. */
async function tendCopies(ports: Ports, folder: string): Promise<void> {
  const { database, secret } = ports
  if (database.backup === null) return
  // If the database cannot be read, no one knows whether the clock is right.
  const isDoubted = await clockDoubted(database.db, ports.day).catch(() => true)
  const days = { day: ports.day(0), oldest: ports.day(-daysOfCopies), clockDoubted: isDoubted }
  const stored = { database, secret, folder, ...days }
  if (!(await hasTeacher(ports))) return pruneCopies(folder, stored)
  await renewCopies(stored)
  await fillReserve(folder)
}

/** Daily work, from two in the night on, or as soon as the server runs on that day. */
async function doNightly(ports: Ports, folder: string): Promise<void> {
  try {
    await everyNight(ports)
  } finally {
    // Old copies go also where nothing can be written.
    await tendCopies(ports, folder)
    ports.database.emptyJournal()
  }
}

/** Does its work once a day, also where the clock is set to another one. */
function daily(ports: Ports, work: () => Promise<unknown>): () => Promise<void> {
  let last = ''
  let notBefore = 0
  return async () => {
    const day = ports.day(0)
    if (day === last || ports.steady() < notBefore) return
    last = day
    await work().catch((error: unknown) => {
      last = ''
      notBefore = ports.steady() + pause
      console.error(`Nightly work failed: ${causeIn(error)}`)
    })
  }
}

/**
 * Ends classes whose day has come, and from then on checks every minute whether the day has changed.
 * @returns stops it, and waits for the work in progress
 */
export async function startNights(ports: Ports, folder: string): Promise<() => Promise<void>> {
  const end = daily(ports, () => endClasses(ports))
  const night = daily(ports, () => doNightly(ports, folder))
  const look = async () => {
    await end()
    if (new Date(ports.now()).getHours() >= quietFrom) await night()
  }
  await end()
  let running = look()
  const timer = setInterval(() => {
    // One after the other: the work of a night may take longer.
    running = running.then(look)
  }, every)
  timer.unref()
  return async () => {
    clearInterval(timer)
    await running
  }
}
