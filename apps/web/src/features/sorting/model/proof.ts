import { kMeansProof, type Proof } from '@botgarten/learning/proof'
import type { Playground } from './playground.svelte.ts'
import { pointsIn, type Work } from './work.ts'

/** The sum of distances that is shown, from the first flags on; where they are not known any more, from this round's. */
export function proofOf({ work, fresh }: Pick<Playground, 'work' | 'fresh'>): Proof | null {
  const { state, table, distance } = work
  if (!state || state.inertia.length === 0) return null
  const rounds = state.inertia.length
  const sorted = { points: pointsIn(table), distance }
  const isSame = fresh?.table === table && fresh.distance === distance
  const proof = isSame
    ? kMeansProof({ ...sorted, centres: fresh.state!.centres, rounds })
    : kMeansProof({ ...sorted, centres: state.before, rounds: 1, before: rounds - 1 })
  return proof && isShown(work, proof) ? proof : null
}

const isShown = ({ state }: Work, { number }: Proof) => number === state!.inertia.at(-1)
