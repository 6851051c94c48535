import { steadyClockOn, type Database } from '@botgarten/classroom'

const every = 60_000

/** The clock for durations. It is stored once a minute: a crash lengthens the rest of each duration by less than that. */
export async function startSteady({ db }: Database) {
  const { now, store } = await steadyClockOn(db, {
    now: () => Date.now(),
    elapsed: () => performance.now(),
  })
  // A database that is away has the time again within a minute after its return.
  const storeOrWait = () => store().catch(() => {})
  await storeOrWait()
  let running = Promise.resolve()
  const timer = setInterval(() => void (running = running.then(storeOrWait)), every)
  timer.unref()
  async function stop() {
    clearInterval(timer)
    await running
    await storeOrWait()
  }
  return { now, stop }
}
