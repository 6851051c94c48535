/** Time that one frame can be late for: a page that slept does not catch up. */
const LONGEST = 250

/** Milliseconds of a frame that learning may take in turbo. The rest is for drawing: after a late frame there is more of it. */
export const budgetFor = (passed: number): number => (passed > 20 ? 4 : 7)

/** Calls once a frame while it runs, with the milliseconds that have passed. */
export class Clock {
  readonly #turn: (passed: number, now: number) => void
  #frame = 0
  #before = 0

  constructor(turn: (passed: number, now: number) => void) {
    this.#turn = turn
  }

  start(): void {
    this.#before = performance.now()
    if (this.#frame === 0) this.#frame = requestAnimationFrame(this.#tick)
  }

  stop(): void {
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
  }

  #tick = (now: number): void => {
    this.#frame = requestAnimationFrame(this.#tick)
    const passed = Math.min(LONGEST, Math.max(0, now - this.#before))
    this.#before = now
    this.#turn(passed, now)
  }
}

/** Resolves when a frame has been drawn: what follows is a task of its own. */
export const nextFrame = (): Promise<unknown> =>
  new Promise((done) => requestAnimationFrame(() => setTimeout(done)))
