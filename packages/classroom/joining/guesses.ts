import { Refusal } from '../refusal.ts'

/** How often something may be wrong. */
export interface Pace {
  /** One after the other without a pause. */
  readonly atOnce: number
  /** And how many more each second. */
  readonly eachSecond: number
}

/** Something that wrong tries are counted under, such as a device, an address or an account. */
export interface Trier {
  /** A keyed hash. */
  readonly key: string
  readonly pace: Pace
  /** Beyond its pace it is not tried at all. Without, the right one still passes. */
  readonly waits?: boolean
}

/** A try that waits for its result. */
export interface Guess {
  /** It was right: it does not count. */
  right(): void
  /** It was wrong. @returns the seconds to wait before the next try: 0 within the pace */
  wrong(): number
}

/** Wrong tries that are remembered of one trier, as a multiple of its `atOnce`: one that stops is free again within hours. */
const mostDebt = 10
/** Triers that are remembered before the half that has not tried for longest is forgotten. */
const mostTriers = 50_000
const longestWait = 30

/** This part of a node's tries is left to those who were never wrong. */
const reserve = 0.1

interface Debt {
  count: number
  /** Was wrong before, however long ago. */
  wasWrong: boolean
  /** When that was, in ms. */
  at: number
}

/**
 * Bounds how many wrong tries a node answers, however many addresses they come from. When they run short, triers that were wrong
 * less often come first: an attacker only takes the tries that others leave. Each node has its own.
 */
export class Guesses {
  private readonly debts = new Map<string, Debt>()
  private readonly elapsed: () => number
  private readonly node: Pace
  private left: number
  private at: number

  /**
   * @param elapsed ms of a clock that never goes back
   * @param node how many wrong tries are answered in all
   */
  constructor(elapsed: () => number, node: Pace) {
    this.elapsed = elapsed
    this.node = node
    this.left = node.atOnce
    this.at = elapsed()
  }

  /** How many triers are remembered. */
  get size(): number {
    return this.debts.size
  }

  /** @throws Refusal 429 where the node has no try left for these triers, or one of them has to wait */
  begin(triers: readonly Trier[]): Guess {
    const debts = triers.map((trier) => this.debtOf(trier))
    for (const [at, { pace, waits }] of triers.entries())
      if (waits && debts[at]!.count + 1 > pace.atOnce) throw tooMany(secondsOver(debts[at]!.count + 1, pace))
    const needed = this.neededBy(triers, debts)
    this.refill()
    if (this.left < needed) throw tooMany(Math.ceil((needed - this.left) / this.node.eachSecond))
    this.count(triers, debts, 1)
    return {
      right: () => this.count(triers, debts, -1),
      wrong: () => {
        for (const debt of debts) debt.wasWrong = true
        return Math.max(0, ...triers.map(({ pace }, at) => secondsOver(debts[at]!.count, pace)))
      },
    }
  }

  /** How many tries the node must have left: few for those who were wrong rarely, nearly all for those far beyond their pace. */
  private neededBy(triers: readonly Trier[], debts: readonly Debt[]): number {
    const use = Math.max(0, ...triers.map(({ pace }, at) => debts[at]!.count / pace.atOnce))
    const ofReserve = debts.some(({ wasWrong }) => wasWrong) ? reserve : 0
    return 1 + (this.node.atOnce - 1) * (ofReserve + (1 - ofReserve) * (use / (1 + use)))
  }

  private refill(): void {
    const now = this.elapsed()
    this.left = Math.min(this.node.atOnce, this.left + ((now - this.at) / 1000) * this.node.eachSecond)
    this.at = now
  }

  private count(triers: readonly Trier[], debts: readonly Debt[], by: 1 | -1): void {
    this.left -= by
    for (const [at, { pace }] of triers.entries()) {
      const debt = debts[at]!
      debt.count = Math.max(0, Math.min(mostDebt * pace.atOnce, debt.count + by))
    }
  }

  private debtOf({ key, pace }: Trier): Debt {
    const at = this.elapsed()
    const found = this.debts.get(key)
    if (!found) {
      if (this.debts.size >= mostTriers) this.forget()
      const debt = { count: 0, wasWrong: false, at }
      this.debts.set(key, debt)
      return debt
    }
    found.count = Math.max(0, found.count - ((at - found.at) / 1000) * pace.eachSecond)
    found.at = at
    // Who tries now is forgotten last.
    this.debts.delete(key)
    this.debts.set(key, found)
    return found
  }

  /** An attacker that comes with new cookies fills the list with triers of one try; its address stays in the newer half. */
  private forget(): void {
    for (const key of this.debts.keys()) {
      if (this.debts.size <= mostTriers / 2) return
      this.debts.delete(key)
    }
  }
}

const secondsOver = (count: number, { atOnce, eachSecond }: Pace) =>
  count <= atOnce ? 0 : Math.min(longestWait, Math.ceil((count - atOnce) / eachSecond))

const tooMany = (seconds: number) => new Refusal(429, 'tooManyTries', { seconds: Math.max(1, seconds) })
