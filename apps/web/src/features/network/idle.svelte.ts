import { tick, untrack } from 'svelte'
import type { NetworkInUse } from '@botgarten/programs'

interface Live {
  readonly outline: NetworkInUse | null
  /** A network is in the hand. */
  readonly isHeld: boolean
  /** Is there room in which it is drawn? */
  readonly isDrawn: boolean
  readonly root: HTMLElement | undefined
}

interface Asked {
  readonly onputin: () => void
  readonly onswitchon: () => void
}

/** A network that does not run: whether its note is open or folded, and its way back into the program. */
export class IdleNetwork {
  readonly #live: () => Live
  readonly #asked: () => Asked
  /** The network whose note was folded. */
  #folded = $state<string | null>(null)
  #isUnfolded = $state(false)
  // Blockly tells of what has been done a little later.
  #isFixing = $state(false)
  readonly #net = $derived.by(() => this.#live().outline)
  readonly why = $derived(this.#net?.idle ?? null)
  /** Is its note open? */
  readonly isNoted = $derived.by(
    () => this.why !== null && !this.#live().isHeld && this.#folded !== this.#net?.id,
  )

  constructor(live: () => Live, asked: () => Asked) {
    this.#live = live
    this.#asked = asked
    $effect(() => {
      // A network that runs and comes loose again says so again.
      if (this.why === null) this.#folded = null
      const stands = this.#net !== null && this.why === null && this.#live().isDrawn
      if (!stands || !untrack(() => this.#isFixing)) return
      this.#isFixing = false
      this.#then('[role=slider]')
    })
  }

  /** Was its note opened by a press? */
  get isUnfolded() {
    return this.#isUnfolded
  }

  fold = () => {
    this.#folded = this.#net?.id ?? null
    this.#isUnfolded = false
    this.#then('.later button')
  }

  unfold = () => {
    this.#folded = null
    this.#isUnfolded = true
  }

  fix = () => {
    this.#isFixing = true
    const { onputin, onswitchon } = this.#asked()
    if (this.why === 'off') onswitchon()
    else onputin()
  }

  /** The button that was pressed goes away: the keyboard goes on from what stands in its place. */
  #then(next: string): void {
    void tick().then(() =>
      this.#live().root?.querySelector<HTMLElement>(next)?.focus({ preventScroll: true }),
    )
  }
}
