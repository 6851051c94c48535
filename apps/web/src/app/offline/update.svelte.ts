import { LAB_LOCK } from './lock.ts'

/** A lab that was just closed may hold its lock for a moment longer: how long to wait for that, in ms. */
const TIMEOUT = 2000

/** Does something while no lab is open, in no tab. @returns whether it was done */
async function whileNoLab(action: () => Promise<void>): Promise<boolean> {
  let begun = false
  await navigator.locks
    .request(LAB_LOCK, { signal: AbortSignal.timeout(TIMEOUT) }, () => {
      begun = true
      return action()
    })
    .catch((cause: unknown) => {
      if (begun) throw cause
    })
  return begun
}

/** A version of the product that has come and waits. The home page asks for it: between lessons, never in one. */
export class Update {
  #waiting = $state.raw<ServiceWorker | null>(null)
  #labOpen = $state(false)

  get isThere() {
    return this.#waiting !== null
  }
  /** The child wanted it, and a lab was open. */
  get labOpen() {
    return this.#labOpen
  }

  /** Looks for a new version, now and while the page is open. */
  async look(): Promise<void> {
    const workers = navigator.serviceWorker as ServiceWorkerContainer | undefined
    const found = await workers?.getRegistration()
    if (!workers || !found) return
    const see = () => {
      // The first one of all is no news.
      if (found.waiting && workers.controller) this.#waiting = found.waiting
    }
    const watch = () => found.installing?.addEventListener('statechange', see)
    see()
    // The page's own registering may have found it already.
    watch()
    found.addEventListener('updatefound', watch)
    await found.update().catch(() => 'without a network there is nothing new')
    see()
  }

  /** Takes the new version and loads the page again, unless a lab is open. */
  async take(): Promise<void> {
    const taken = await whileNoLab(async () => {
      const over = new Promise((done) =>
        navigator.serviceWorker.addEventListener('controllerchange', done, { once: true }),
      )
      this.#waiting?.postMessage('take over')
      await over
    })
    this.#labOpen = !taken
    if (taken) location.reload()
  }
}
