import { expect, test } from 'vitest'
import type { LearnedRun } from '@botgarten/programs'
import { content } from '@botgarten/content/files'
import { courseOf } from '@botgarten/maps'
import { learningIn } from '@botgarten/programs'
import { byTask, csvOf, rowOf } from './records.svelte.ts'

const run: LearnedRun = {
  ...{ map: 'railway', start: 3, goal: 1, closed: '3-2 2-3', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 },
  ...{ rules: 'standard', seed: 1, episodes: 100, moves: 640, limitEpisodes: 100, limitMoves: 10_000 },
  ...{ way: '3-5-0-1', shortest: 3, found: 4, guess: '' },
}

test('every run is a row under one head', () => {
  const [head, row, end] = csvOf([run]).split('\r\n')
  expect(head!.split(',')).toHaveLength(row!.split(',').length)
  expect(row).toBe('railway,3,1,3-2 2-3,standard,0.5,0.8,0.1,0.5,100,10000,1,100,640,3-5-0-1,3,4,,')
  expect(end).toBe('')
  expect(csvOf([{ ...run, pay: 'length 3:10' }])).toContain(',length 3:10\r\n')
})

test('what a child typed stays one cell and is no formula', () => {
  expect(csvOf([{ ...run, guess: '3, "5"' }])).toContain('"3, ""5"""')
  expect(csvOf([{ ...run, guess: '=1+1' }])).toContain(",'=1+1")
})

test('runs of one task stand together under the numbers they have among all', () => {
  const other = { ...run, goal: 2 }
  const tables = byTask([run, other, { ...run, alpha: 0.9 }])
  expect(tables.map(({ first, rows }) => [first, rows.map(({ row }) => row)])).toEqual([
    [run, [1, 3]],
    [other, [2]],
  ])
})

test('a run of a single try has no way and names no try that found it, but the shortest way has two sections', () => {
  const outline = { ...learningIn(content.program('railway', 'start')!.programs['main']!)!, episodes: 1 }
  const course = courseOf(outline, content.mapFile('railway')!, 1)
  while (!course.over) course.advance(1000)
  expect(csvOf([rowOf(outline, course, 1, '')])).toMatch(/,1,\d+,,2,0,,\r\n$/)
})
