import { titleOf } from '#content/names.ts'
import { m } from '#words/message.ts'
import type { Ancestor, Item } from './item.ts'

/** Who shared it. */
export const byLine = ({ by, own }: Pick<Item, 'by' | 'own'>): string =>
  own ? m['shared.byYou']() : m['shared.by']({ name: by })

function fromAncestor({ title, by, own }: Ancestor): string {
  if (title === null || by === null) return m['shared.fromSomebody']()
  return own ? m['shared.fromYours']({ title }) : m['shared.from']({ title, name: by })
}

/** What it was made from last: something shared, a card, or nothing. */
export function fromLine({ from, card }: Pick<Item, 'from' | 'card'>): string {
  if (from) return fromAncestor(from)
  return card === null ? m['shared.ownProject']() : m['shared.fromCard']({ card: titleOf(card) })
}
