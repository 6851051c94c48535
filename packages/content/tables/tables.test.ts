import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { decodeTable, readTable, TableError } from './index.ts'

const limits = { rows: 1000, columns: 4 }
/** Without how it was understood: that has tests of its own. */
function read(text: string, options?: Parameters<typeof readTable>[2]) {
  const { reading: _, ...table } = readTable(text, limits, options)
  return table
}

describe('a table is read', () => {
  test.each([
    ['with commas and points', 'x,y\n1.5,-2\n3,4e2\n'],
    ['as a German spreadsheet writes it', '\uFEFFx;y\r\n1,5;-2\r\n3;400\r\n'],
    ['with tabs', 'x\ty\n1,5\t-2\n3\t400'],
    ['with quotes and empty lines', '"x","y"\n\n"1,5","-2"\n"3","400"\n\n'],
  ])('%s', (_, text) => {
    expect(read(text)).toEqual({
      columns: ['x', 'y'],
      rows: [
        [1.5, -2],
        [3, 400],
      ],
    })
  })

  test('without a heading its columns have numbers', () => {
    expect(read('1;2\n3;4').columns).toEqual(['1', '2'])
    expect(read('7')).toEqual({ columns: ['1'], rows: [[7]] })
  })

  test.each([
    ['under a heading of one cell', 'Länge\r\n1,5\r\n2,25\r\n'],
    ['under a heading in quotes', '\uFEFF"Länge"\n1,5\n2,25\n'],
  ])('one column with decimal commas, %s', (_, text) => {
    expect(read(text)).toEqual({ columns: ['Länge'], rows: [[1.5], [2.25]] })
  })

  test.each([
    ['where some numbers have no comma', '1,5\n3\n-2,5', [[1.5], [3], [-2.5]]],
    ['where a comma stands before a zero', '1,05\n2,25', [[1.05], [2.25]]],
    ['in quotes', '"1,5"\n"2,25"', [[1.5], [2.25]]],
  ])('one column with decimal commas, %s', (_, text, rows) => {
    expect(read(text)).toEqual({ columns: ['1'], rows })
  })

  test('where nothing tells, commas part cells; that they may be decimal is said, and asked for it is so', () => {
    const text = '1,5\n2,25\n'
    expect(read(text)).toEqual({
      columns: ['1', '2'],
      rows: [
        [1, 5],
        [2, 25],
      ],
      maybeOneColumn: true,
    })
    expect(read(text, { decimalComma: true })).toEqual({ columns: ['1'], rows: [[1.5], [2.25]] })
    expect(read('x,y\n1,5\n2,25').maybeOneColumn).toBeUndefined()
    expect(read('1,5,7\n2,25,8').maybeOneColumn).toBeUndefined()
    expect(read('1.5,2\n2,25').maybeOneColumn).toBeUndefined()
  })

  const tenths = fc.integer({ min: -9999, max: 9999 }).map((value) => value / 10)
  test('any one column of tenths under its heading comes back as it was, commas or points in it', () => {
    fc.assert(
      fc.property(fc.array(tenths, { minLength: 1, maxLength: 30 }), (values) => {
        const rows = values.map((value) => [value + 0])
        for (const point of [',', '.']) {
          const text = ['Höhe', ...values.map((value) => String(value).replace('.', point))].join('\r\n')
          expect(read(text)).toEqual({ columns: ['Höhe'], rows })
        }
      }),
      { seed: 8 },
    )
  })

  const cell = fc.double({ noNaN: true, noDefaultInfinity: true }).map((value) => value + 0)
  const numbers = fc
    .integer({ min: 1, max: 4 })
    .chain((width) =>
      fc.array(fc.array(cell, { minLength: width, maxLength: width }), { minLength: 1, maxLength: 20 }),
    )

  test.each([
    [',', '.'],
    [';', ','],
    ['\t', '.'],
  ])('any numbers, with "%s" between them and "%s" inside, come back as they were', (mark, point) => {
    fc.assert(
      fc.property(numbers, (rows) => {
        // Without a decimal comma somewhere, and alone in its row, a semicolon cannot be told.
        const text = rows
          .map((row) => row.map((value) => String(value).replace('.', point)).join(mark))
          .join('\n')
        if (mark === ';' && rows[0]!.length === 1) return
        expect(read(text).rows).toEqual(rows)
      }),
    )
  })

  test('whatever stands in a file, it is a table of finite numbers or a clear error', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary' }), (text) => {
        try {
          const { columns, rows } = read(text)
          expect(rows.flat().every(Number.isFinite)).toBe(true)
          expect(rows.every((row) => row.length === columns.length)).toBe(true)
        } catch (error) {
          expect(error).toBeInstanceOf(TableError)
        }
      }),
    )
  })
})

describe('how a table was understood is said', () => {
  test.each([
    ['x,y\n1.5,2', { mark: 'comma', decimal: 'point', heading: true }],
    ['1;2,5\n3;4', { mark: 'semicolon', decimal: 'comma', heading: false }],
    ['1\t2\n3\t4', { mark: 'tab', decimal: null, heading: false }],
    ['Länge\n1,5\n2', { mark: null, decimal: 'comma', heading: true }],
    ['1,5\n2,25', { mark: 'comma', decimal: null, heading: false }],
    ['7', { mark: null, decimal: null, heading: false }],
  ] as const)('%j', (text, reading) => expect(readTable(text, limits).reading).toEqual(reading))

  test('a comma that may be either is a decimal comma when that is asked for', () => {
    const { reading } = readTable('1,5\n2,25', limits, { decimalComma: true })
    expect(reading).toEqual({ mark: null, decimal: 'comma', heading: false })
  })
})

describe('the letters of a file', () => {
  const text = 'Länge;Höhe\r\n1,5;2\r\n'
  const utf16 = (big: boolean, mark: boolean) => {
    const bytes = Buffer.from(mark ? `\uFEFF${text}` : text, 'utf16le')
    return big ? bytes.swap16() : bytes
  }
  test.each([
    ['utf-8', Buffer.from(text)],
    ['utf-8', Buffer.from(`\uFEFF${text}`)],
    ['utf-16le', utf16(false, true)],
    ['utf-16be', utf16(true, true)],
    ['utf-16le', utf16(false, false)],
    ['utf-16be', utf16(true, false)],
    ['windows-1252', Buffer.from(text, 'latin1')],
  ])('%s', (encoding, bytes) => expect(decodeTable(bytes)).toEqual({ text, encoding }))

  test('whatever bytes there are, they are text or a clear error', () => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 100 }), (bytes) => {
        try {
          readTable(decodeTable(bytes).text, limits)
        } catch (error) {
          expect(error).toBeInstanceOf(TableError)
        }
      }),
    )
  })

  test.each(['PK\x03\x04', '\xD0\xCF\x11\xE0'])('a file of a spreadsheet is named: %j', (start) => {
    expect(() => decodeTable(Buffer.from(`${start}rest`, 'latin1'))).toThrow(
      expect.objectContaining({ problem: 'spreadsheet' }),
    )
  })
})

test('a number that is too big is said with its place, where there is a largest one', () => {
  const most = { ...limits, largest: 1e140 }
  expect(readTable('x,y\n1e140,-1e140', most).rows).toEqual([[1e140, -1e140]])
  expect(() => readTable('x,y\n1,2\n3,-1e308', most)).toThrow(
    expect.objectContaining({ problem: 'tooBig', facts: { row: 3, column: 2, cell: '-1e308', most: 1e140 } }),
  )
})

test.each([
  ['', 'empty', {}],
  [' \n\n', 'empty', {}],
  ['x,y\n1,2\n1,NaN', 'noNumber', { row: 3, column: 2, cell: 'NaN' }],
  ['1,2\n1,Infinity', 'noNumber', { row: 2, column: 2, cell: 'Infinity' }],
  ['1,2\napple,3', 'noNumber', { row: 2, column: 1, cell: 'apple' }],
  ['1;\n2;3', 'noNumber', { row: 1, column: 2, cell: '' }],
  ['1;2\n3', 'unequalRows', { row: 2, cells: 1, columns: 2 }],
  ['x,y\n1,2\n3', 'unequalRows', { row: 3, cells: 1, columns: 2 }],
  ['1;1.234\n2;0,5', 'twoPoints', { row: 1, column: 2, cell: '1.234' }],
  ['1.234,5;2', 'noNumber', { row: 1, column: 1, cell: '1.234,5' }],
  ['1,2,3,4,5', 'manyColumns', { columns: 5, most: 4 }],
  ['1\n'.repeat(1001), 'manyRows', { most: 1000 }],
  [`x\n${'1\n'.repeat(1_000_000)}`, 'manyRows', { most: 1000 }],
])('what is wrong is named with its place (%#)', (text, problem, facts) => {
  expect(() => read(text)).toThrow(expect.objectContaining({ problem, facts }))
})
