import { qProof, type Proof } from '@botgarten/learning/proof'
import { courseOn } from '#figures/map/stage.ts'
import type { Learning } from './learning.svelte.ts'

/** The value that the shown step has changed, computed again from the first move on. */
export function proofOf({ stage, outline, seed, shown }: Learning): Proof | null {
  const trace = shown?.trace
  const course = stage && outline && courseOn(stage, outline, seed)
  if (!trace?.decision || !course) return null
  const proof = qProof(course.learner, trace.t, trace.action)
  return proof.number === trace.after ? proof : null
}
