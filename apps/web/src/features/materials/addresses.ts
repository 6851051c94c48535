import { titleOf } from '#content/names.ts'
import materials from 'content:items'
import { resolve } from '$app/paths'
import { allCards } from '#content/cards.ts'
import { m, say } from '#words/say.ts'
import { itemNamed, textOf } from './library.ts'

/** Where a link of an item leads: `card:<id>` to the lab, `item:<id>` to the item, everything else elsewhere. */
export function addressOf(href: string): string {
  const [, kind, id] = /^(card|item):(.+)$/.exec(href) ?? []
  if (kind === 'card') return resolve('/lab/[card]', { card: id! })
  if (kind !== 'item') return href
  const item = itemNamed(id!)
  return item ? resolve('/materials/[kind]/[id]', { kind: item.kind, id: item.id }) : href
}

/** What `card:<id>` or `item:<id>` is called, in the language of now. */
export function nameOfTarget(target: string): string {
  const [kind, id] = target.split(':') as [string, string]
  const item = itemNamed(id)
  return kind === 'item' && item ? textOf(item).title : titleOf(id)
}

/**
 * What somebody looks for who has only paper: `Folien 1: Wie lernt dein Roboter?`, `NN 5: Freundschaft`.
 * Where the words of the link already end with the number, the name is enough.
 */
export function numberedName(target: string, words = ''): string {
  const [kind, id] = target.split(':') as [string, string]
  const item = kind === 'item' ? itemNamed(id) : undefined
  const name = nameOfTarget(target)
  if (item && new RegExp(`\\b${item.number}$`).test(words)) return name
  const number = item
    ? m['materials.kindAndNumber']({ kind: say(`materials.kind.${item.kind}`), number: item.number })
    : allCards.find((card) => card.id === id)?.code
  return number === undefined ? name : m['materials.numberedName']({ number, name })
}

/** Address of a picture by its path below `content/materials`. */
export const { pictureAt } = materials
