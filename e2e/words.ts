import { content } from '@botgarten/content/files'
import { basename } from 'node:path'
import { fill, type Facts } from '@botgarten/messages'
import { completeLanguages, wordsOf } from '@botgarten/messages/folder'

/** The languages that are promised complete; the screen of any other one is tested by its messages alone. */
export const languages = completeLanguages
export type Language = (typeof languages)[number]

/**
 * The languages in which the tests of a file run: one of them, or all where `BOTGARTEN_LANGUAGES` is `all`. Which one hangs on
 * the sample of `npm run test:full`: the next part takes the next language. Behaviour does not depend on the language; that
 * words fit on every screen in every language has a test of its own. Files of one language follow each other: a page is
 * used again only in its language.
 */
export function languagesOf(file: string): readonly Language[] {
  if (process.env['BOTGARTEN_LANGUAGES'] === 'all') return languages
  const letter = basename(file).charCodeAt(0) - 'a'.charCodeAt(0)
  const turn = Number(process.env['BOTGARTEN_SAMPLE'] ?? 0)
  return [languages[(Math.floor((letter / 26) * languages.length) + turn) % languages.length]!]
}

const words = new Map(languages.map((language) => [language, wordsOf(language)]))

/**
 * The text of a message key (`lab.start`) in a language. Throws if there is none. No-break spaces are replaced by plain spaces,
 * as in the text that Playwright reads from a page.
 */
export function message(language: Language, key: string, facts: Facts = {}): string {
  const found = words.get(language)?.[key]
  if (found === undefined) throw new Error(`No word for ${key} in ${language}`)
  return fill(found, facts, language).replaceAll('\u00a0', ' ')
}

/** What a card's check is called in a language. Throws where nobody wrote it. */
export function checkMessage(language: Language, card: string, id: string): string {
  const said = content.card(card)?.text[language]?.checks[id]
  if (!said) throw new Error(`No word for the check ${id} of ${card} in ${language}`)
  return said
}

/** In which part of its bed a card lies; undefined for the first, by hand. */
export const chapterOf = (card: string) => content.cards.find(({ id }) => id === card)?.chapter

/** The bed of a card on the home page; undefined for no card, such as the free lab. */
export const bedOf = (card: string) => content.cards.find(({ id }) => id === card)?.bed

/** What a card is called in a language. Throws where there is no such card. */
export function cardMessage(language: Language, id: string): string {
  const card = content.cards.find((one) => one.id === id)
  if (!card) throw new Error(`There is no card ${id}`)
  return card.title[language]!
}
