import type { Hub } from '@botgarten/classroom'

const flushEvery = 250
const tickEvery = 5000

/** Gives a hub its time: several flushes a second, a tick every few seconds. @returns stops it */
export function startLive(hub: Hub): () => void {
  let flushing = false
  const flush = async () => {
    if (flushing) return
    flushing = true
    await hub.flush()
    flushing = false
  }
  const timers = [setInterval(() => void flush(), flushEvery), setInterval(() => hub.tick(), tickEvery)]
  for (const timer of timers) timer.unref()
  return () => timers.forEach(clearInterval)
}
