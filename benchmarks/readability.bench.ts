import { content } from '@botgarten/content/files'
import { cardWords, gradeOf, wordsOf } from '@botgarten/content/items'
import type { Table } from './bench.ts'

const shown = (grade: number | null) => (grade === null ? '–' : grade.toFixed(1))

/** For which grade every material is written, and which its words suit. */
export default function readability(): Promise<Table> {
  const { languages } = content
  const rowOf = (name: string, grades: readonly number[], words: (language: string) => string) => [
    ...[name, grades.join(' to ')],
    ...languages.map((language) => shown(gradeOf(words(language), language))),
  ]
  const cards = content.cards.map(({ id }) => {
    const { card, text } = content.card(id)!
    return rowOf(content.cardFolder(id), card.grades, (language) => cardWords(text[language]!))
  })
  const texts = new Map(languages.map((language) => [language, content.itemTexts(language).items]))
  const items = content.items.map(({ id, kind, audience, grades }) => {
    const folder = content.itemFolder(id)
    const name = audience === 'teachers' ? `${folder} (teachers)` : folder
    return rowOf(name, grades, (language) => wordsOf(texts.get(language)![`${kind}/${id}`]!, false))
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
