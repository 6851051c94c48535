import type { Playground } from '@botgarten/content'
import type { IconName } from '#parts/icons.ts'
import type { Need } from './face.ts'

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
