import { createSubscriber } from 'svelte/reactivity'

const step = 1000

/** The time of day for what is shown in seconds and minutes: it goes on while somebody looks. */
class Clock {
  readonly #subscribe = createSubscriber((update) => {
    const timer = setInterval(update, step)
    return () => clearInterval(timer)
  })

  /** Ms since 1970. */
  get now(): number {
    this.#subscribe()
    return Date.now()
  }
}

export const clock = new Clock()
