import { kMeansProof, type Proof } from '@botgarten/learning/proof'
import { pointsIn, type Work } from './work.ts'

/** The sum of distances that is shown, from the first flags on. */
export function proofOf(work: Work): Proof | null {
  const { state, start, table, distance } = work
  if (!state || state.inertia.length === 0) return null
  const proof = kMeansProof({
    ...{ points: pointsIn(table), distance, centres: start, rounds: state.inertia.length },
  })
  return proof && isShown(work, proof) ? proof : null
}

const isShown = ({ state }: Work, { number }: Proof) => number === state!.inertia.at(-1)
