import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { codeBook, codeBookRows, everyLine } from './code-book.ts'

const docs = readFileSync(join(import.meta.dirname, '../../../../docs/study.md'), 'utf8')

/** Rows of the table under the heading, without the line of dashes. */
const tableIn = (text: string) =>
  text
    .split('\n')
    .filter((line) => line.startsWith('|') && !/^\|[ :|-]+\|$/.test(line))
    .map((line) =>
      line
        .slice(1, -1)
        .split(' | ')
        .map((cell) => cell.trim().replaceAll('`', '')),
    )

test('the docs have the code book as it is', () => {
  const plain = codeBookRows().map((row) => row.map((cell) => cell.replaceAll('`', '')))
  expect(tableIn(docs.split('## The log')[1]!)).toEqual(plain)
})

test('every event and every field says what it means', () => {
  const events = Object.values(codeBook)
  const fields: (readonly string[])[] = [
    ...Object.values(everyLine),
    ...events.flatMap((event) => Object.values<readonly string[]>(event.fields)),
  ]
  for (const meaning of [...events.map((one) => one.meaning), ...fields.map(([, said]) => said!)])
    expect(meaning).toMatch(/^\S.*[.?]$/)
})
