import { spawnSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { isLong } from '@botgarten/numbers/testing'
import { expect, test } from 'vitest'
import { readLog, rowsOfTable, tableOf } from './index.ts'
import reference from './reference/study.json' with { type: 'json' }

const folder = join(import.meta.dirname, 'reference')
const docs = readFileSync(join(import.meta.dirname, '../../../docs/study.md'), 'utf8')
const { lines } = readLog(readFileSync(join(folder, 'log.jsonl'), 'utf8'))
const table = tableOf(lines)

test('the table of a log is the one that pandas makes of it', () => {
  expect(table).toEqual(reference.table)
})

test('the file of the table names each figure of a child and has it in that column', () => {
  const never = { ...table[0]!, firstRun: null }
  const [names, ...rows] = rowsOfTable([table[0]!, never])
  expect(names!.toSorted()).toEqual(Object.keys(table[0]!).sort())
  const asRecords = rows.map((row): unknown => Object.fromEntries(row.map((cell, k) => [names![k], cell])))
  expect(asRecords).toEqual([table[0], { ...never, firstRun: '' }])
})

test('the lines for pandas in the docs are those that were run, and print tries and first runs', () => {
  const [code] = [.../```python\n(.*?)```/s.exec(docs)!].slice(1)
  expect(code).toBe(reference.lines)
  expect(code!.trim().split('\n')).toHaveLength(3)
  const printed = reference.printed.filter(([first]) => /^\d{4}[A-Z]$/.test(first!))
  const runs = table.filter(({ tries }) => tries > 0)
  expect(printed.map(([pseudonym, tries]) => [pseudonym, Number(tries)])).toEqual(
    runs.map(({ pseudonym, tries }) => [pseudonym, tries]),
  )
})

// `npm run test:long` needs a python3 with pandas.
if (isLong)
  test('pandas, run now, says what it said when the reference was made', () => {
    const { status, stdout, stderr } = spawnSync('python3', [join(folder, 'study.py')], { encoding: 'utf8' })
    expect(status, stderr).toBe(0)
    expect(JSON.parse(stdout)).toEqual(reference)
  })

test('the lines for R in the docs are three', () => {
  const [, code] = /```r\n(.*?)```/s.exec(docs)!
  expect(code!.trim().split('\n')).toHaveLength(3)
})
