import { pictureOf } from '#content/cards.ts'
import type { Embed, Item } from '@botgarten/content/items'
import { textOf } from '../library.ts'
import { wayLooks } from '../looks.ts'

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
