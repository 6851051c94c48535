import type { IconName } from '#parts/icons.ts'
import type { Item } from '@botgarten/content/items'

type Way = Item['way']

/** Each way of learning has the colours of its playground (card.css), its icon, and a card whose picture stands for it. */
export const wayLooks: {
  readonly [way in Way]: { readonly colours: string; readonly icon: IconName; readonly picture: string }
} = {
  supervised: { colours: 'network', icon: 'network', picture: 'friendship' },
  reinforcement: { colours: 'q-learning', icon: 'route', picture: 'railway' },
  unsupervised: { colours: 'sorting', icon: 'shapes', picture: 'tidy-up' },
  all: { colours: 'drive', icon: 'sprout', picture: 'forward' },
}
