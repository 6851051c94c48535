import { everyNight, hasTeacher, lastBackup, nightlyBackup, type Ports } from '@botgarten/classroom'
import { causeIn } from './problem.ts'

const every = 10 * 60_000
const quietFrom = 2

/** Does what is due: once a day, from two in the night on, or as soon as the server runs on that day. */
async function doNightly(ports: Ports, folder: string): Promise<void> {
  await everyNight(ports)
  const { database, secret } = ports
  const day = ports.day(0)
  if (database.backup === null || lastBackup(folder)?.day === day) return
  if (await hasTeacher(ports)) await nightlyBackup({ database, secret, folder, day })
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
