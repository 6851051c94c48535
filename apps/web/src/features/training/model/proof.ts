import { beginExercise, exerciseBy, prepare, stepSettings } from '@botgarten/learning/neural-network/examples'
import { percentOff } from '@botgarten/learning/neural-network/train'
import { netProof, type Proof } from '@botgarten/learning/proof'
import { sharesPractice } from './kind.ts'
import type { Practice } from './practice.svelte.ts'
import { mostRounds } from './rehearsal.ts'

/** The error of the round that is shown: it practises again from the beginning, in slices that leave time for frames. */
export async function proofOf(practice: Practice): Promise<Proof | null> {
  const { note, net, layers, examples, mirror, outcome } = practice
  const { point } = outcome
  if (!note || !net || !examples || !point) return null
  const shown = { id: net.id, layers, weights: note.start, examples }
  const exercise = { ...exerciseBy(note, shown, mirror), from: 'knobs' as const }
  const prepared = prepare(exercise)
  if (prepared.data.practised.count === 0) return null
  const settings = { ...stepSettings(note), rounds: mostRounds, patience: 0 }
  const proof = await inSlices(netProof(beginExercise(prepared, settings, exercise), point.round))
  const loss = point.kept ?? point.practised
  return proof.number === (sharesPractice(practice) ? loss : percentOff(loss)) ? proof : null
}

/** Milliseconds of a slice. */
const slice = 8

async function inSlices<Made>(making: Generator<undefined, Made>): Promise<Made> {
  for (;;) {
    const until = performance.now() + slice
    while (performance.now() < until) {
      const { done, value } = making.next()
      if (done) return value
    }
    await new Promise((next) => setTimeout(next))
  }
}
