import { resolve } from '$app/paths'
import type { LoadedCard } from '#lib/content/cards.ts'
import { textOf } from '#lib/parts/card/face.ts'
import { m } from '#lib/words/generated/messages.js'
import { say } from '#lib/words/say.ts'
import type { NextStep, Task } from './parts/frame.ts'

/** What is to be done, and which checks are green. */
export function taskOf(card: LoadedCard | null, green: readonly string[]): Task {
  if (!card) return { title: m['session.freeCall'](), sentence: m['session.freeSentence'](), goals: [] }
  const { goal, checks } = textOf(card)
  const goals = card.card.checks.map(({ id }) => ({
    id,
    label: checks[id] ?? id,
    passed: green.includes(id),
  }))
  return { title: goal.call, sentence: goal.sentence, goals }
}

/** After a card has been solved from a start pose: another pose first, then the next card. */
export function nextStep(card: LoadedCard, passedStarts: readonly number[]): NextStep {
  const index = card.card.starts.findIndex((_, start) => !passedStarts.includes(start))
  if (index >= 0) return { kind: 'start', index }
  const { next } = card.card
  return next
    ? { kind: 'card', href: resolve('/lab/[card]', { card: next }), name: say(`home.${next}`) }
    : { kind: 'none' }
}
