import { percentOff } from '@botgarten/learning/neural-network/train'
import { m } from '#words/message.ts'
import { sharesPractice } from '../model/kind.ts'
import type { Practice } from '../model/practice.svelte.ts'
import { number } from './messages.ts'

/** How the error of the round that is shown comes about. */
export function linesOf(practice: Practice): string[] {
  const { outcome, prepared, layers } = practice
  const { point } = outcome
  if (!point || !prepared) return []
  const { kept, practised } = prepared.data
  const loss = point.kept ?? point.practised
  const over = m['proof.net.over']({
    examples: point.kept === null ? practised.count : kept.count,
    outputs: layers.at(-1)?.length ?? 0,
  })
  if (sharesPractice(practice))
    return [m['proof.net.shared'](), over, m['proof.net.entropy']({ value: number(loss, 4) })]
  const facts = { square: number(loss, 6), percent: number(percentOff(loss), 2) }
  return [m['proof.net.mean'](), over, m['proof.net.sum'](facts)]
}
