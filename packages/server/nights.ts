import {
  daysOfCopies,
  everyNight,
  hasTeacher,
  fillReserve,
  pruneCopies,
  renewCopies,
  type Ports,
} from '@botgarten/classroom'
import { causeIn } from './problem.ts'

const every = 10 * 60_000
const quietFrom = 2

/** A backup of today where there is none yet, and the end of old copies. */
async function tendCopies(ports: Ports, folder: string): Promise<void> {
  const { database, secret } = ports
  if (database.backup === null) return
  const days = { day: ports.day(0), oldest: ports.day(-daysOfCopies), clockDoubted: false }
  const stored = { database, secret, folder, ...days }
  if (!(await hasTeacher(ports))) return pruneCopies(folder, stored)
  await renewCopies(stored)
  await fillReserve(folder)
}

/** Does what is due: once a day, from two in the night on, or as soon as the server runs on that day. */
async function doNightly(ports: Ports, folder: string): Promise<void> {
  try {
    await everyNight(ports)
  } finally {
    // Old copies go also where nothing can be written.
    await tendCopies(ports, folder)
    ports.database.emptyJournal()
  }
}

/** Looks every ten minutes whether a day began. @returns stops it, and waits for what runs */
export function startNights(ports: Ports, folder: string): () => Promise<void> {
  let [last, running] = ['', Promise.resolve()]
  const look = () => {
    const day = ports.day(0)
    if (day === last || new Date(ports.now()).getHours() < quietFrom) return
    last = day
    running = doNightly(ports, folder).catch((error: unknown) => {
      // It is tried again at the next look; a full disk may have room by then.
      last = ''
      console.error(`Nightly work failed: ${causeIn(error)}`)
    })
  }
  const timer = setInterval(look, every)
  timer.unref()
  look()
  return async () => {
    clearInterval(timer)
    await running
  }
}
