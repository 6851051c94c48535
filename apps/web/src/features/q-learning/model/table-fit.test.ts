import { describe, expect, it } from 'vitest'
import { tableFit } from './table-fit.ts'

/** A map of as many stations, each with four roads. */
const four = (stations: number) => Array.from({ length: stations }, () => 4)

describe('how the table of all moves fits', () => {
  it('is a matrix where every station has a column of 47 px beside the headings', () => {
    expect(tableFit(four(10), 34 + 10 * 47)).toEqual({ isMatrix: true })
    expect(tableFit(four(10), 33 + 10 * 47).isMatrix).toBe(false)
  })

  it('is none with more than ten stations, however wide the page is', () => {
    expect(tableFit(four(11), 3000).isMatrix).toBe(false)
  })

  it('has rows in two columns, in the largest boxes that fit', () => {
    // Two columns of 30 px heading and four boxes with 3 px each, and 8 px between them.
    const width = (cell: number) => 8 + 2 * (30 + 4 * (cell + 3))
    expect(tableFit(four(16), width(44)).cell).toBe(44)
    expect(tableFit(four(16), width(44) - 1).cell).toBe(41)
    expect(tableFit(four(16), width(36)).cell).toBe(36)
  })

  it('has one column of rows where two do not fit', () => {
    expect(tableFit(four(16), 375).cell).toBeUndefined()
  })
})
