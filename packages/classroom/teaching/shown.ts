import type { ClassRow } from '../database/tables.ts'
import { wordsOfKey } from '../joining/code.ts'
import type { Ports } from '../ports.ts'
import { endsSoon } from './ending-store.ts'

export const languageOf = ({ language }: Pick<ClassRow, 'language'>) => (language === 'de' ? 'de' : 'en')

/** The cards that are free today; null: all. */
export const cardsIn = (cards: string | null): readonly string[] | null =>
  cards === null ? null : (JSON.parse(cards) as string[])

/** The end of the joining window by the clock of the server; null while joining is closed. */
function joiningUntil({ joiningUntil: end }: ClassRow, { now, steady }: Pick<Ports, 'now' | 'steady'>) {
  const left = end - steady()
  return left > 0 ? now() + left : null
}

/** What a teacher sees of a class. */
export const shownClass = (row: ClassRow, ports: Pick<Ports, 'now' | 'steady' | 'day'>) => ({
  ...{ id: row.id, name: row.name, language: row.language, grade: row.grade, code: row.code },
  words: wordsOfKey(row.code, languageOf(row)),
  ...{ open: row.openedAt !== null, joiningUntil: joiningUntil(row, ports) },
  ...{ endsOn: row.endsOn, endsSoon: endsSoon(row, ports.day) },
  ...{ cards: cardsIn(row.cards), level: row.level },
})

/** A class that has ended and is not deleted yet, in the list of its teacher: its name without any content. */
export const hiddenClass = ({ id, name, language, grade, endsOn }: ClassRow) => ({
  ...{ id, name, language, grade, endsOn, hidden: true },
  ...{ code: '', words: [], open: false, joiningUntil: null, endsSoon: false, cards: null, level: null },
})
