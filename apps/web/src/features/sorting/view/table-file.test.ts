import { beforeAll, describe, expect, test } from 'vitest'
import { language } from '#words/language.svelte.ts'
import { fetchWords, m } from '#words/message.ts'
import { openTable } from './table-file.ts'

const file = (content: string | Uint8Array<ArrayBuffer>) => new File([content], 'table.csv')
const said = async (content: string | Uint8Array<ArrayBuffer>) => (await openTable(file(content))).sentence

describe.each(['de', 'en'] as const)('what is said of a table in %s', (locale) => {
  const own = (words: { readonly de: string; readonly en: string }) => words[locale]

  beforeAll(async () => {
    await language.speak(locale)
    await fetchWords('sorting')
  })

  test('how it was read', async () => {
    expect(await said('Länge\r\n1,5\r\n2\r\n')).toBe(
      own({
        de: 'Gelesen: eine Spalte, 2 Zeilen, Dezimalkomma, oben die Überschrift.',
        en: 'Read: one column, 2 rows, decimal comma, a heading on top.',
      }),
    )
    expect(await said(new Uint8Array(Buffer.from('\uFEFF1.5\t2\r\n', 'utf16le')))).toBe(
      own({
        de: 'Gelesen: 2 Spalten mit Tabulatoren dazwischen, 1 Zeile, Dezimalpunkt, Schrift UTF-16.',
        en: 'Read: 2 columns with tabs between them, 1 row, decimal point, letters in UTF-16.',
      }),
    )
    expect(await said(new Uint8Array(Buffer.from('Länge;Höhe\n1;2', 'latin1')))).toContain('Windows-1252')
  })

  test('what is wrong with it', async () => {
    expect(await said('x;y\n1;2\n3;-1e308')).toBe(
      own({
        de: 'Zeile 3, Spalte 2: „-1e308“ ist zu groß zum Vergleichen. Vertippt?',
        en: 'Row 3, column 2: “-1e308” is too big to be compared. A typing mistake?',
      }),
    )
    expect(await said('')).toBe(m['sorting.table.empty']())
    expect(await said('x;y\n1;2\nNaN;3')).toBe(
      own({
        de: 'Zeile 3, Spalte 1: „NaN“ ist keine Zahl.',
        en: 'Row 3, column 1: “NaN” is not a number.',
      }),
    )
    expect(await said('x;y\n1;apple')).toBe(m['sorting.table.noNumber']({ row: 2, column: 2, cell: 'apple' }))
    expect(await said('1;2\n3')).toBe(m['sorting.table.unequalRows']({ row: 2, cells: 1, columns: 2 }))
    expect(await said('1\n'.repeat(1_000_000))).toBe(m['sorting.table.manyRows']({ most: 5000 }))
    expect(await said('1\n'.repeat(2_500_001))).toContain('5\u00a0MB')
    expect(await said('PK\u0003\u0004')).toContain('CSV')
    const { table } = await openTable(file('1e140;-1e140\n1;2'))
    expect(table!.rows).toHaveLength(2)
  })
})

test('a file that has gone is said', async () => {
  const gone = Object.assign(file('1'), {
    arrayBuffer: () => Promise.reject(new DOMException('gone', 'NotFoundError')),
  })
  expect((await openTable(gone)).table).toBeNull()
})
