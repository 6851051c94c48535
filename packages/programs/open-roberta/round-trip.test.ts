import { readFileSync, readdirSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { xmlTree } from '../testing/xml-tree.ts'
import { readOpenRoberta, writeOpenRoberta } from './index.ts'

const folder = new URL('../testing/open-roberta/programs/', import.meta.url)
const files = readdirSync(folder)
const textOf = (file: string) => readFileSync(new URL(file, folder), 'utf8')

it('there are the 90 given programs', () => {
  expect(files).toHaveLength(90)
})

describe.each(files)('%s', (file) => {
  it('is an equal document after reading and writing', () => {
    const text = textOf(file)
    const program = readOpenRoberta(text)
    expect(xmlTree(writeOpenRoberta(program))).toEqual(xmlTree(text))
    expect(readOpenRoberta(writeOpenRoberta(program))).toEqual(program)
  })
})
