import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { cardWords, gradeOf, wordsOf } from '@botgarten/content/items'
import { flat, formsOf, type Tree } from '@botgarten/messages'
import type { Table } from './bench.ts'

const shown = (grade: number | null) => (grade === null ? '–' : grade.toFixed(1))

/** Words of screens that children of every grade read, by their files. */
const screens = [
  'app',
  'tour',
  'missed',
  'network',
  'q-learning',
  'sorting',
  'projects',
  'time',
  'world-building',
  'training',
  'map-designer',
  'inside',
  'robots',
  'robot',
  'help',
  'class',
  'share',
  'files',
]

/** The sentences of a file of messages: labels and names of buttons are none. What is filled in is one word. */
function sentencesOf(file: string, language: string): string {
  const path = new URL(`../content/words/${language}/${file}.json`, import.meta.url)
  const { $schema: _schema, ...tree } = JSON.parse(readFileSync(path, 'utf8')) as Tree
  return Object.values(flat(tree))
    .map((message) =>
      formsOf(message)
        .at(-1)!
        .replaceAll(/\{\w+\}/g, 'Bo'),
    )
    .filter((text) => /[.!?]$/.test(text))
    .join('\n')
}

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
  const sentences = screens.map((file) =>
    rowOf(`words/${file} (screen)`, [3, 12], (language) => sentencesOf(file, language)),
  )
  return Promise.resolve({
    title: 'Readability of the materials',
    how: 'German: 4. Wiener Sachtextformel; English: Flesch-Kincaid grade level. Words of cards with hints, of slides without notes; tables are left out; of screens their whole sentences. “–”: fewer than 30 words.',
    columns: ['material', 'grades', ...languages],
    rows: [...cards, ...items, ...sentences],
    notes: [
      'What pupils read may be at most one grade above their youngest; that is tested. It may be easier: short sentences, one step each, are wanted, and both formulas then fall below the grades they were made for (4 and 1).',
      'What teachers read is listed and not held to a grade.',
    ],
  })
}
