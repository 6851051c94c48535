import { countsTable, csv, sentencesTable, total } from '@botgarten/answers'
import type { FormItem, LoadedForm } from '@botgarten/content/questionnaires'
import { zipSync } from 'fflate'
import { message } from '#words/message.ts'
import { columnsIn, optionOf, optionsOf, questionOf, textOf } from './forms.ts'
import { chance } from './sheets.svelte.ts'
import type { Source } from './source.ts'

/** What each column holds: the question, and what each value means. */
function codeBook(loaded: LoadedForm): readonly (readonly string[])[] {
  const text = textOf(loaded)
  const meaning = (item: FormItem) =>
    optionsOf(item)
      .map((option) => `${option} = ${optionOf(item, text, option)}`)
      .join('; ')
  const right = (item: FormItem) => columnsIn(loaded).find(({ id }) => id === item.id)?.answer ?? ''
  return [
    ['column', 'kind', 'question', 'values', 'right'],
    ['grades', 'group', message('form.book.grades'), '', ''],
    ...loaded.form.items.map((item) => [
      item.id,
      item.kind,
      questionOf(item, text, 'question'),
      meaning(item),
      right(item),
    ]),
  ]
}

/** All that is published of a form as tables: children, counts, sentences an item, and what the columns mean. */
export async function tablesOf(source: Source, loaded: LoadedForm): Promise<Uint8Array<ArrayBuffer>> {
  const columns = columnsIn(loaded)
  const tallies = source.tallies(loaded)
  const { id } = loaded.form
  const sentences = columns
    .filter(({ kind }) => kind === 'text')
    .map((column) => [`${id}-${column.id}.csv`, sentencesTable(column.id, total(tallies), chance)] as const)
  const tables = {
    [`${id}.csv`]: await source.rows(loaded),
    [`${id}-counts.csv`]: countsTable(columns, tallies),
    ...Object.fromEntries(sentences),
    'code-book.csv': codeBook(loaded),
  }
  const encoder = new TextEncoder()
  return zipSync(
    Object.fromEntries(Object.entries(tables).map(([name, rows]) => [name, encoder.encode(csv(rows))])),
  )
}
