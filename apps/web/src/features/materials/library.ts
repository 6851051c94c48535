import { fetchWords } from '#words/message.ts'
import { titleOf } from '#content/names.ts'
import materials from 'content:items'
import { allCards } from '#content/cards.ts'
import { language, type Locale } from '#words/language.svelte.ts'
import type { ItemTexts } from '@botgarten/content/catalogue'
import type { Item, ItemMarkdown, ItemText, Synonyms } from '@botgarten/content/items'
import type { Question, QuestionText } from '@botgarten/content/questions'

const texts = new Map<Locale, ItemTexts>()

/** Brings the words of the learning materials: before one of them is shown. */
export async function fetchItems(locale: Locale = language.locale): Promise<void> {
  language.needs(fetchItems)
  if (!texts.has(locale)) texts.set(locale, await materials.itemTexts(locale))
}

/** What materials say, and what they show: networks, tables of trials, groups, worlds, cages. */
const wordsShown = ['materials', 'network', 'q-learning', 'sorting', 'worlds', 'reward-zoo'] as const

/** All that a page of learning materials needs before it says anything. */
export const fetchMaterials = async (): Promise<void> => {
  await Promise.all([fetchItems(), fetchWords(...wordsShown)])
}

/** All learning materials, in the order of their folders. */
export const allItems = materials.items
export const allQuestions: readonly Question[] = materials.questions
/** Questions of a module: all of them, or these. */
export const questionsOf = (module: number, only?: readonly string[]): readonly Question[] =>
  allQuestions.filter((one) => one.module === module && (only?.includes(one.id) ?? true))

export const itemNamed = (id: string) => allItems.find((item) => item.id === id)

const ways: { readonly [bed: string]: Item['way'] } = {
  ...{ drive: 'all', network: 'supervised', 'q-learning': 'reinforcement', sorting: 'unsupervised' },
}

/** A card of the lab alone, as an item of two sides; undefined for what is no card. */
export function cardItem(id: string): Item | undefined {
  const card = allCards.find((one) => one.id === id)
  const set = card && allItems.find((item) => item.kind === 'card' && item.way === ways[card.bed])
  return set && { ...set, ...{ id, code: card.code, grades: card.grades, minutes: card.minutes, sides: 2 } }
}

/** All that the library offers: the items, and each card that is not an item already, by itself. */
export const offeredItems: readonly Item[] = [
  ...allItems,
  ...allCards
    .filter(({ code }) => allItems.every((item) => item.code !== code))
    .flatMap(({ id }) => cardItem(id) ?? []),
]

/** What `item:<id>` or `card:<id>` names. */
export function targetItem(target: string): Item | undefined {
  const [kind, id = ''] = target.split(':')
  return kind === 'item' ? itemNamed(id) : cardItem(id)
}

/** How an item is named where it is copied: `item:<id>`, a single card `card:<id>`. */
export const targetOf = ({ id }: Pick<Item, 'id'>): string => `${itemNamed(id) ? 'item' : 'card'}:${id}`

/** Words for the same thing in the language of now, in groups. */
export const synonyms = (): Synonyms => texts.get(language.locale)?.synonyms ?? []

const bothSides = (id: string): ItemMarkdown => [
  { type: 'embed', embed: { kind: 'card', id, side: 'front' } },
  { type: 'embed', embed: { kind: 'page' } },
  { type: 'embed', embed: { kind: 'card', id, side: 'back' } },
]

/** As the sets of cards are written: its name as a heading, then both sides. */
function cardText(id: string): ItemText {
  const title = titleOf(id)
  return { title, lead: [], sections: [{ title, body: bothSides(id), notes: [] }] }
}

/** An item's words in the language of now. @throws Error where they were not brought: a mistake in the page */
export function textOf({ kind, id }: Pick<Item, 'kind' | 'id'>): ItemText {
  const all = texts.get(language.locale)?.items
  const text = all?.[`${kind}/${id}`]
  if (all && !text && kind === 'card') return cardText(id)
  if (!text) throw new Error(`The words of "${kind}/${id}" are not here.`)
  return text
}

/** A question's words in the language of now. @throws Error where they were not brought: a mistake in the page */
export function questionText(id: string): QuestionText {
  const text = texts.get(language.locale)?.questions[id]
  if (!text) throw new Error(`The words of the question "${id}" are not here.`)
  return text
}
