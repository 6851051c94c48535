import { meanLoss } from './errors.ts'
import { forwardOver } from './forward.ts'
import { finishThisRound } from './step.ts'
import type { Practice } from './types.ts'

/** Mean losses with the weights after a round; round 0 is before the first one. */
export interface CurvePoint {
  readonly round: number
  readonly practised: number
  /** Of what is held back; null where nothing is. */
  readonly kept: number | null
}

/** A curve has at most so many points: of long practice not every round is measured. */
const mostPoints = 1000

/** The errors with the weights of now. */
export const pointOf = (practice: Practice): CurvePoint => ({
  round: practice.round,
  practised: meanLoss(practice, practice.practised)!,
  kept: meanLoss(practice, practice.kept),
})

/** Practises to its end and gives the curve, its first and its last round always in it. */
export function practise(practice: Practice): readonly CurvePoint[] {
  const curve = beginCurve(practice)
  practiseFor(practice, curve, Infinity)
  return curve
}

export const beginCurve = (practice: Practice): CurvePoint[] => [pointOf(practice)]

/** Practises whole rounds until about so many examples are done, and goes on with the curve. Returns whether practice is over. */
export function practiseFor(practice: Practice, curve: CurvePoint[], examples: number): boolean {
  const every = Math.ceil(practice.settings.rounds / mostPoints)
  for (let done = 0; practice.ended === null && done < examples; done += practice.practised.count) {
    finishThisRound(practice)
    if (practice.round % every === 0 || practice.ended !== null) curve.push(pointOf(practice))
  }
  return practice.ended !== null
}

/**
 * Since which round practice learns by heart: what it practises gets better and what is held back worse, by a tenth, for at
 * least 20 rounds. Null: it does not.
 */
export function byHeartSince(curve: readonly CurvePoint[]): number | null {
  const measured = curve.filter(({ kept }) => kept !== null)
  const last = measured.at(-1)
  if (!last) return null
  const best = measured.reduce((a, b) => (b.kept! < a.kept! ? b : a))
  const isByHeart =
    last.round - best.round >= 20 && last.kept! > 1.1 * best.kept! && last.practised < best.practised
  return isByHeart ? best.round : null
}

/** Hidden ReLU neurons that no practised example wakes: their sum is never above 0, so that nothing can change them. */
export function sleepingIn(practice: Practice): readonly string[] {
  const { net, practised, sums } = practice
  const inputs = net.layers[0]?.inputs ?? 0
  const hidden = net.neurons.slice(1, -1).flat()
  const awake = new Uint8Array(hidden.length)
  for (let row = 0; row < practised.count; row++) {
    forwardOver(practice, practised.inputs, row)
    for (let k = 0; k < hidden.length; k++) if (sums[inputs + k]! > 0) awake[k] = 1
  }
  return hidden.filter(({ activation }, k) => activation === 'relu' && awake[k] === 0).map(({ id }) => id)
}
