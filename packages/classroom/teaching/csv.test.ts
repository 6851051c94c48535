import fc from 'fast-check'
import Papa from 'papaparse'
import { expect, test } from 'vitest'
import { csv, csvCell } from './csv.ts'

test.each(['=1+1', '+49', '-3', '@sum', '\tx'])('%j is no formula', (text) =>
  expect(csvCell(text).replace(/^"/, '')).toMatch(/^'/),
)

test('any table is read again as it was by a reader of CSV', () => {
  const cell = fc.string({ unit: 'grapheme' }).filter((text) => !/^[=+\-@\t\r]/.test(text))
  const table = fc.array(fc.array(cell, { minLength: 2, maxLength: 2 }), { minLength: 1, maxLength: 5 })
  fc.assert(
    fc.property(table, fc.constantFrom('de', 'en'), (rows, language) => {
      const delimiter = language === 'de' ? ';' : ','
      const text = csv(rows, language).slice(1)
      const read = Papa.parse<string[]>(text, { delimiter, newline: '\r\n' }).data.slice(0, -1)
      expect(read).toEqual(rows)
    }),
  )
})
