import { pictureOf, type LoadedCard } from '#content/cards.ts'
import { language } from '#words/language.svelte.ts'
import type { Card, CardText, Playground } from '@botgarten/content'
import type { Markdown } from '#parts/markdown.ts'

/** What is laid out under "You need" on a card. */
export type Need = Card['needs'][number]

/** The front of a card. */
export interface CardFace {
  readonly id: string
  readonly title: string
  /** "NN 1". */
  readonly code: string
  /** Where it lies on the home page: its name and its colour. */
  readonly bed: Playground
  /** Address of the card's picture, or null. */
  readonly picture: string | null
  readonly story: Markdown
  /** What Bo should do, in one sentence. */
  readonly goal: string
  readonly further: Markdown
  readonly needs: readonly Need[]
  readonly minutes: number
  readonly fromGrade: number
}

/** Words of a card in the language of the screen. */
export const textOf = (loaded: LoadedCard): CardText => loaded.text[language.locale] ?? loaded.text['en']!

export function faceOf(loaded: LoadedCard): CardFace {
  const { title, story, goal, further } = textOf(loaded)
  const { id, code, needs, minutes, grades } = loaded.card
  return {
    ...{ id, title, code, story, further, needs, minutes },
    bed: loaded.bed,
    picture: pictureOf(id),
    goal: goal.sentence,
    fromGrade: grades[0],
  }
}
