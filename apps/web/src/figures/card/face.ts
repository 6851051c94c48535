import { pictureOf, type LoadedCard } from '#content/cards.ts'
import { language } from '#words/language.svelte.ts'
import type { Card, CardText, Playground } from '@botgarten/content'
import type { Project } from '@botgarten/programs'
import type { Markdown } from '#parts/markdown.ts'
import type { IconName } from '#parts/icons.ts'

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
  /** World and pictures of a card that somebody has made: they are drawn in the picture's place. */
  readonly made?: Pick<Project, 'world' | 'assets'>
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
    ...(loaded.assets && { made: { world: loaded.world, assets: loaded.assets } }),
    goal: goal.sentence,
    fromGrade: grades[0],
  }
}

interface Look {
  readonly icon: IconName
  /** Key of the words on the card's head. */
  readonly words: string
}

/** What a card of each bed has on its head; its colours are in `card.css`, by the bed's name. */
export const looks: { readonly [bed in Playground]: Look } = {
  network: { icon: 'network', words: 'lab.network' },
  'q-learning': { icon: 'route', words: 'lab.learning' },
  sorting: { icon: 'shapes', words: 'category.sorting' },
  drive: { icon: 'play', words: 'lab.firstDrive' },
}

/** Key of the words of what is laid out for a card. */
export const needWords = (need: Need): string => `lab.need${need[0]!.toUpperCase()}${need.slice(1)}`
