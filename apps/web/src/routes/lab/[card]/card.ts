import type { LoadedCard } from '#lib/content/cards.ts'
import { language } from '#lib/words/language.svelte.ts'
import { m } from '#lib/words/generated/messages.js'
import { say } from '#lib/words/say.ts'
import type { CheckResult } from '@botgarten/lab'
import type { CardText, MarkdownNode } from '@botgarten/materials'
import type { CardFace, NextStep, Task } from './parts/frame.ts'

export const textOf = (card: LoadedCard): CardText => card.text[language.locale] ?? card.text['en']!

const paragraph = (value: string): MarkdownNode => ({
  type: 'paragraph',
  children: [{ type: 'text', value }],
})

/** The front of a card as the frame shows it. */
export function faceOf(loaded: LoadedCard): CardFace {
  const { title, story, goal, further } = textOf(loaded)
  const { code, needs, minutes, grades } = loaded.card
  return {
    title,
    code,
    picture: loaded.picture,
    sections: { story, goal: [paragraph(goal.sentence)], further },
    needs,
    minutes,
    fromGrade: grades[0],
  }
}

/** What is to be done, and how far it is. */
export function taskOf(card: LoadedCard | null, checks: readonly CheckResult[]): Task {
  if (!card) return { title: m['session.freeCall'](), sentence: m['session.freeSentence'](), goals: [] }
  const { call, sentence } = textOf(card).goal
  const goals = checks.map(({ id, passed }) => ({ id, label: say(`check.${card.card.id}.${id}`), passed }))
  return { title: call, sentence, goals }
}

/** After a card has been solved from a start pose: another pose first, then the next card. */
export function nextStep(card: LoadedCard, passedStarts: readonly number[]): NextStep {
  const index = card.card.starts.findIndex((_, start) => !passedStarts.includes(start))
  if (index >= 0) return { kind: 'start', index }
  const { next } = card.card
  return next ? { kind: 'card', href: `/lab/${next}`, name: say(`home.${next}`) } : { kind: 'none' }
}
