import type { Watched } from '@botgarten/lab/trying'
import type { Pose } from '@botgarten/simulation'

/** Poses a second: three times as fast as Bo drives. */
const pace = 60
/** Time that one frame can be late for, in ms: a page that slept does not catch up. */
const latest = 250

/** Plays drives one after the other. */
export class Player {
  #drives = $state.raw<readonly Watched[]>([])
  #drive = $state(0)
  /** Poses that are over. */
  #at = $state(0)
  #frame = $state(0)
  #before = 0

  get playing() {
    return this.#frame !== 0
  }
  /** Which of the drives is shown, from 0. */
  get drive() {
    return this.#drive
  }
  /** Where it has been so far; empty before anything is shown. */
  get trail(): readonly Pose[] {
    return this.#drives[this.#drive]?.poses.slice(0, Math.floor(this.#at) + 1) ?? []
  }
  /** Coins of the move that was over last; null before the first one. */
  get paid(): number | null {
    const drive = this.#drives[this.#drive]
    return drive?.coins[Math.floor(this.#at / drive.posesAMove) - 1] ?? null
  }

  show(drives: readonly Watched[]): void {
    this.#drives = drives
    this.again()
  }

  again(): void {
    this.#drive = 0
    this.#at = 0
    this.#before = performance.now()
    if (this.#frame === 0 && this.#drives.length > 0) this.#frame = requestAnimationFrame(this.#tick)
  }

  stop(): void {
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
  }

  #tick = (now: number): void => {
    const { poses } = this.#drives[this.#drive]!
    const passed = Math.min(latest, Math.max(0, now - this.#before))
    this.#before = now
    this.#at = Math.min(poses.length - 1, this.#at + (passed * pace) / 1000)
    if (this.#at >= poses.length - 1) {
      if (this.#drive + 1 >= this.#drives.length) return this.stop()
      this.#drive++
      this.#at = 0
    }
    this.#frame = requestAnimationFrame(this.#tick)
  }
}
