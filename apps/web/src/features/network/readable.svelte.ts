import type { NetView } from '@botgarten/lab'
import type { Weights } from '@botgarten/learning/neural-network'
import { calm } from '#drawing/calm.ts'

interface Live {
  /** A new object once a frame while it runs. */
  readonly trace: NetView | null
  readonly weights: Weights
  readonly running: boolean
}

/** Frames for which a number stands. */
const frames = 6
/** Milliseconds for which what a hand does is shown with every frame. */
const atOnce = 100

/** Numbers that change 60 times a second cannot be read; what a hand does to a weight is seen at once. */
export function readable(live: () => Live): { readonly trace: NetView | null } {
  const turn = calm(frames)
  let trace = $state.raw<NetView | null>(null)
  let shown: Weights | null = null
  let pulledAt = -Infinity
  $effect.pre(() => {
    const { trace: next, weights, running } = live()
    const now = performance.now()
    if (weights !== shown) pulledAt = now
    shown = weights
    if (turn(now, running && next !== null && now - pulledAt > atOnce)) trace = next
  })
  return {
    get trace() {
      return trace
    },
  }
}
