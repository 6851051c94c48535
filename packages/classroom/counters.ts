/** Sums of amounts that are open at the same time, by a name. */
export class Counters {
  private readonly amounts = new Map<string, number>()

  /**
   * Enters if the sum stays within `most`, or if nothing else is open.
   * @returns a function for its end, which may be called again; null if there is too much
   */
  enter(name: string, amount: number, most: number): (() => void) | null {
    const before = this.amounts.get(name) ?? 0
    if (before > 0 && before + amount > most) return null
    this.amounts.set(name, before + amount)
    let isOpen = true
    return () => {
      if (isOpen) this.leave(name, amount)
      isOpen = false
    }
  }

  private leave(name: string, amount: number) {
    const left = (this.amounts.get(name) ?? 0) - amount
    if (left > 0) this.amounts.set(name, left)
    else this.amounts.delete(name)
  }
}
