/** Devices that are remembered before those whose time is over are forgotten. */
const mostDevices = 10_000

/** Devices that have sent too many requests, until the time when the next one may pass. */
export class Refused {
  private readonly until = new Map<string, number>()
  private readonly elapsed: () => number

  /** @param elapsed ms of a clock that never goes back */
  constructor(elapsed: () => number) {
    // Whole ms: differences of fractions would round a second up to two.
    this.elapsed = () => Math.floor(elapsed())
  }

  /** @param seconds until it may send again */
  note(device: string, seconds: number): void {
    if (this.until.size >= mostDevices) this.forget()
    this.until.set(device, this.elapsed() + seconds * 1000)
  }

  /** Whole seconds until a device may send again; 0: it may now. */
  secondsOf(device: string): number {
    const until = this.until.get(device)
    return until === undefined ? 0 : Math.max(0, Math.ceil((until - this.elapsed()) / 1000))
  }

  private forget(): void {
    for (const [device, until] of this.until) if (until <= this.elapsed()) this.until.delete(device)
  }
}
