import type { Pace } from './joining/guesses.ts'

interface Bucket {
  /** Below 0: a debt. */
  left: number
  /** When that was, in ms. */
  at: number
}

/** Buckets that are remembered before the full ones are forgotten. */
const mostBuckets = 10_000

/** Bounds how much each of many pupils, classes or addresses may have, by a monotonic clock. */
export class Buckets {
  private readonly buckets = new Map<string, Bucket>()
  private readonly elapsed: () => number
  private readonly pace: Pace

  /** @param elapsed ms of a clock that never goes back */
  constructor(elapsed: () => number, pace: Pace) {
    this.elapsed = elapsed
    this.pace = pace
  }

  private leftIn({ left, at }: Bucket): number {
    const { atOnce, eachSecond } = this.pace
    return Math.min(atOnce, left + ((this.elapsed() - at) / 1000) * eachSecond)
  }

  private bucketOf(key: string): Bucket {
    const found = this.buckets.get(key)
    if (found) {
      found.left = this.leftIn(found)
      found.at = this.elapsed()
      return found
    }
    if (this.buckets.size >= mostBuckets) this.forget()
    const bucket = { left: this.pace.atOnce, at: this.elapsed() }
    this.buckets.set(key, bucket)
    return bucket
  }

  private forget(): void {
    for (const [key, bucket] of this.buckets)
      if (this.leftIn(bucket) >= this.pace.atOnce) this.buckets.delete(key)
  }

  /** How many are remembered. */
  get size(): number {
    return this.buckets.size
  }

  /** Whole seconds until the bucket holds as much, or is full; 0: it does now. */
  secondsUntil(key: string, amount = 1): number {
    const needed = Math.min(amount, this.pace.atOnce)
    const { left } = this.bucketOf(key)
    return left < needed ? Math.ceil((needed - left) / this.pace.eachSecond) : 0
  }

  /** Takes an amount, also one that leaves a debt. */
  charge(key: string, amount: number): void {
    this.bucketOf(key).left -= amount
  }

  /** Takes an amount if the bucket holds as much. @returns whole seconds to wait if not; 0 if it was taken */
  take(key: string, amount = 1): number {
    const seconds = this.secondsUntil(key, amount)
    if (seconds === 0) this.charge(key, amount)
    return seconds
  }
}
