import { readCard, readCardText } from '@botgarten/materials'
import { readItem, readItemText } from '@botgarten/materials/items'
import { cardWords } from '../packages/materials/items/cardWords.ts'
import { gradeOf } from '../packages/materials/items/readability.ts'
import {
  cardFolders,
  itemFolders,
  languages,
  read,
  textOf,
} from '../packages/materials/items/testing/catalogue.ts'
import { wordsOf } from '../packages/materials/items/walk.ts'
import type { Table } from './bench.ts'

const shown = (grade: number | null) => (grade === null ? '–' : grade.toFixed(1))

/** For which grade every material is written, and which its words suit. */
export default function readability(): Promise<Table> {
  const rowOf = (name: string, grades: readonly number[], words: (language: string) => string) => [
    ...[name, grades.join(' to ')],
    ...languages.map((language) => shown(gradeOf(words(language), language))),
  ]
  const cards = cardFolders.map((folder) =>
    rowOf(folder, readCard(read(folder, 'card.json')).grades, (language) =>
      cardWords(readCardText(textOf(folder, language))),
    ),
  )
  const items = itemFolders.map((folder) => {
    const { audience, grades } = readItem(read(folder, 'item.json'))
    const name = audience === 'teachers' ? `${folder} (teachers)` : folder
    return rowOf(name, grades, (language) => wordsOf(readItemText(textOf(folder, language)), false))
  })
  return Promise.resolve({
    title: 'Readability of the materials',
    how: 'German: 4. Wiener Sachtextformel; English: Flesch-Kincaid grade level. Words of cards with hints, of slides without notes; tables are left out. “–”: fewer than 30 words.',
    columns: ['material', 'grades', ...languages],
    rows: [...cards, ...items],
    notes: [
      'What pupils read may be at most one grade above their youngest; that is tested. It may be easier: short sentences, one step each, are wanted, and both formulas then fall below the grades they were made for (4 and 1).',
      'What teachers read is listed and not held to a grade.',
    ],
  })
}
