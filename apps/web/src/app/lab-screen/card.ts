import { titleOf } from '#content/names.ts'
import { resolve } from '$app/paths'
import type { LoadedCard } from '#content/cards.ts'
import { textOf } from '#figures/card/face.ts'
import { m } from '#words/message.ts'

export interface Goal {
  readonly id: string
  /** A word or two: "comes near". */
  readonly label: string
  readonly passed: boolean
  /** It was passed in a run before this one. */
  readonly earned: boolean
}

interface Task {
  readonly title: string
  /** The goal in one sentence. */
  readonly sentence: string
  /** Empty in the free lab: the strip is one line then. */
  readonly goals: readonly Goal[]
}

/** What comes after all goals. `start`: index of a pose not yet passed · `again`: that did not count, it is tried from this pose. */
export type NextStep =
  | { readonly kind: 'start'; readonly index: number }
  | { readonly kind: 'again'; readonly index: number }
  | { readonly kind: 'card'; readonly href: string; readonly name: string }
  | { readonly kind: 'home' | 'zoo'; readonly href: string }

/** Another map than the card's, on which a child has its robot learn. */
interface Elsewhere {
  readonly map: string
  readonly start: number
  readonly goal: number
}

/**
 * What is to be done, which checks are green, and which ones were in a run before. On another map the card's goals are
 * nowhere: the sentence follows the map.
 */
export function taskOf(
  card: LoadedCard | null,
  green: readonly string[],
  earned: readonly string[],
  elsewhere: Elsewhere | null = null,
): Task {
  if (!card) return { title: m['session.freeCall'](), sentence: m['session.freeSentence'](), goals: [] }
  if (elsewhere)
    return {
      title: m['session.otherMapCall'](elsewhere),
      sentence: m['session.otherMapSentence'](elsewhere),
      goals: [],
    }
  const { goal, checks } = textOf(card)
  const goals = card.card.checks.map(({ id }) => ({
    id,
    label: checks[id] ?? id,
    passed: green.includes(id),
    earned: earned.includes(id),
  }))
  return { title: goal.call, sentence: goal.sentence, goals }
}

/** All goals are green in a run that does not count: from which start pose it is tried again. */
export function againFrom({ card }: LoadedCard, chosen: number, passedStarts: readonly number[]): NextStep {
  const open = card.starts.findIndex((_, start) => !passedStarts.includes(start))
  return { kind: 'again', index: chosen >= 0 ? chosen : Math.max(0, open) }
}

/** After a card has been solved from a start pose: another pose first, then the next card. */
export function nextStep(card: LoadedCard, passedStarts: readonly number[]): NextStep {
  const index = card.card.starts.findIndex((_, start) => !passedStarts.includes(start))
  if (index >= 0) return { kind: 'start', index }
  const { next, place } = card.card
  if (next) return { kind: 'card', href: resolve('/lab/[card]', { card: next }), name: titleOf(next) }
  return place ? { kind: place, href: resolve('/zoo') } : { kind: 'home', href: resolve('/') }
}
