import type { IconName } from '#parts/icons.ts'
import type { Item, Embed } from '@botgarten/content/items'
import { pictureOf } from '#content/cards.ts'
import { textOf } from './library.ts'

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

/** The card of the lab that is printed here, or that a code leads to. */
function cardOf(embed: Embed): string[] {
  if (embed.kind === 'card') return [embed.id]
  return embed.kind === 'qr' && embed.to.startsWith('card:') ? [embed.to.slice('card:'.length)] : []
}

/** What stands on the thumbnail of an item: Bo where Bo greets first, else the picture of its first card, else its way's. */
export function thumbOf(item: Item): { readonly bo: true } | { readonly picture: string | null } {
  const { lead, sections } = textOf(item)
  const embeds = [...lead, ...sections.flatMap(({ body }) => body)].flatMap((node) =>
    node.type === 'embed' && item.kind === 'card' ? [node.embed] : [],
  )
  if (embeds[0]?.kind === 'robot') return { bo: true }
  const card = embeds.flatMap(cardOf)[0] ?? wayLooks[item.way].picture
  return { picture: pictureOf(card) }
}

/** How high the lines are that are written on: the younger, the higher. */
export const handOf = ({ grades: [from] }: Item): string =>
  from <= 4 ? 'from-3' : from <= 6 ? 'from-5' : 'from-7'

/** Whose eyes decide how small its words may be on paper: the youngest alone, all pupils, or teachers. */
export const readersOf = ({ audience, grades }: Item): string =>
  audience === 'teachers' ? '' : grades[1] <= 4 ? 'pupils youngest' : 'pupils'
