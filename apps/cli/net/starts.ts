import { cardDocument } from '@botgarten/content'
import type { LoadedCard } from '@botgarten/content/catalogue'
import { content } from '@botgarten/content/files'
import { createLab } from '@botgarten/lab'
import type { Brain } from '@botgarten/learning/neural-network'
import type { Project } from '@botgarten/programs'
import { TICKS_PER_SECOND } from '@botgarten/simulation'

/** From how many of a card's start poses Bo passes all its checks with this brain; without a card there are none. */
export function startsPassed(
  { programs, brains }: Project,
  card: LoadedCard | null,
  network: string,
  brain: Brain,
): { readonly passed: number; readonly of: number } {
  if (!card) return { passed: 0, of: 0 }
  const { starts, checks } = card.card
  const program = { programs, brains: { ...brains, [network]: brain } }
  const seconds = Math.max(60, ...checks.map((check) => check.seconds))
  const passed = starts.filter((_, start) => {
    const document = cardDocument(card.world, card.card, program, start)
    const lab = createLab()
    lab.load(document, content.floorOf(document.world), { seed: 1, checks })
    lab.start()
    lab.advance(seconds * TICKS_PER_SECOND)
    const view = lab.view()
    return view.problem === null && view.checks.every((check) => check.passed)
  }).length
  return { passed, of: starts.length }
}
