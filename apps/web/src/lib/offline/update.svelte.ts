import { whileNoLab } from './lock.ts'

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
    see()
    found.addEventListener('updatefound', () => found.installing?.addEventListener('statechange', see))
    await found.update().catch(() => 'without a network there is nothing new')
    see()
  }

  /** Takes the new version and loads the page anew, unless a lab is open. */
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
