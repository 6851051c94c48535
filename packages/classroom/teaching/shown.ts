import type { ClassRow } from '../database/tables.ts'
import { wordsOfKey } from '../joining/code.ts'
import type { Ports } from '../ports.ts'

export const languageOf = ({ language }: Pick<ClassRow, 'language'>) => (language === 'de' ? 'de' : 'en')

/** The cards that are free today; null: all. */
export const cardsIn = (cards: string | null): readonly string[] | null =>
  cards === null ? null : (JSON.parse(cards) as string[])

/** What a teacher sees of a class. */
export const shownClass = (row: ClassRow, ports: Pick<Ports, 'now'>) => ({
  ...{ id: row.id, name: row.name, language: row.language, grade: row.grade, code: row.code },
  words: wordsOfKey(row.code, languageOf(row)),
  ...{ open: row.openedAt !== null, joiningUntil: row.joiningUntil > ports.now() ? row.joiningUntil : null },
  ...{ endsOn: row.endsOn, endsSoon: row.announcedDay !== null },
  ...{ cards: cardsIn(row.cards), level: row.level },
})
