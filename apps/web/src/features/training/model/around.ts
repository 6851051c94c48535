import type { Surroundings } from './host.ts'

/** Time as it passes, in a worker or on a page. Without a wait the next turn comes at once, and messages come between. */
export function realTime(): Pick<Surroundings, 'now' | 'later'> {
  const turns = new MessageChannel()
  let next: (() => void) | null = null
  turns.port1.onmessage = () => next?.()
  return {
    now: () => performance.now(),
    later(act, ms) {
      next = act
      if (ms > 0) setTimeout(act, ms)
      else turns.port2.postMessage(null)
    },
  }
}
