import { titleOf } from '#content/names.ts'
import materials from 'content:items'
import { resolve } from '$app/paths'
import { allCards } from '#content/cards.ts'
import { m, message } from '#words/message.ts'
import { itemNamed, textOf, allItems } from './library.ts'
import { codeOfAll, type Item } from '@botgarten/content/items'

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
 * Where the words of the link already are or end with the number, the name is enough; where they are the name, its number is.
 */
export function numberedName(target: string, words = ''): string {
  const [kind, id] = target.split(':') as [string, string]
  const item = kind === 'item' ? itemNamed(id) : undefined
  const name = nameOfTarget(target)
  if (item && new RegExp(`\\b${item.number}$`).test(words)) return name
  const number = item
    ? (codeOfAll(item) ??
      m['materials.kindAndNumber']({ kind: message(`materials.kind.${item.kind}`), number: item.number }))
    : allCards.find((card) => card.id === id)?.code
  if (number === undefined || words.trim() === number) return name
  return words.trim() === name ? number : m['materials.numberedName']({ number, name })
}

/** Address of a picture by its path below `content/materials`. */
export const { pictureAt } = materials

/** The page that prints an item: cards two on a sheet of A4. */
export const onPaper = ({ kind, id }: Pick<Item, 'kind' | 'id'>): string =>
  resolve('/materials/[kind]/[id]?paper=a4', { kind, id })

/** What will Bo do? The questions before and after an item's module; null where it belongs to none. */
export const questionsOf = ({ module }: Pick<Item, 'module'>): string | null =>
  module > 0 ? resolve('/materials/[kind]/[id]', { kind: 'questions', id: String(module) }) : null

/** The teacher's solutions to a set of cards; null for what has none. */
export function solutionsOf({ kind, way }: Pick<Item, 'kind' | 'way'>): Item | null {
  if (kind !== 'card') return null
  const solutions = allItems.filter((item) => item.kind === 'solution')
  // One sheet has those of the first drive and of sorting.
  return solutions.find((one) => one.way === way) ?? solutions.find((one) => one.way === 'all') ?? null
}
