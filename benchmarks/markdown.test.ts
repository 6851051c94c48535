import { expect, test } from 'vitest'
import { median, percentile } from './bench.ts'
import { markdown, writtenBelow } from './markdown.ts'

test('a table names its machine, its date and the command that makes it', () => {
  const table = {
    title: 'Speed',
    how: 'Run ten times.',
    columns: ['what', 'times'],
    rows: [['free', 2000]],
    notes: ['One core.'],
  }
  const made = { command: 'npm run bench -- speed', machine: 'a laptop', date: '2026-11-21' }
  expect(markdown(table, made).split('\n')).toEqual([
    '# Speed',
    '',
    'Run ten times.',
    '',
    '| what | times |',
    '| --- | --- |',
    '| free | 2000 |',
    '',
    '- One core.',
    '',
    '2026-11-21 · a laptop',
    '',
    'Made by `npm run bench -- speed`.',
    '',
  ])
})

test('what people have written below a table stays', () => {
  expect(writtenBelow('# Speed\n\n| a |\n\n## What bounds it\n\nThe wheel.\n')).toBe(
    '\n## What bounds it\n\nThe wheel.\n',
  )
  expect(writtenBelow('# Speed\n')).toBe('')
})

test('the median is the value in the middle, whatever the order', () => {
  expect(median([9, 1, 5])).toBe(5)
  expect(median([4, 3, 2, 1])).toBe(2)
})

test('a percentile is the nearest rank: of 20 values the 19th is the 95th percentile', () => {
  const values = Array.from({ length: 20 }, (_, index) => 20 - index)
  expect(percentile(values, 0.95)).toBe(19)
  expect(percentile(values, 1)).toBe(20)
  expect(percentile([7], 0.5)).toBe(7)
})
