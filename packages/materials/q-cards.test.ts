import { globSync, readFileSync } from 'node:fs'
import { basename, dirname, join } from 'node:path'
import { learningIn } from '@botgarten/programs'
import { describe, expect, test } from 'vitest'
import { courseOf, readMap } from '@botgarten/maps'
import type { CardProgram } from './types.ts'

const content = join(import.meta.dirname, '../../content')
const folders = globSync(join(content, 'cards/q-learning/*/card.json')).sort().map(dirname)
const read = (...path: string[]) => readFileSync(join(...path), 'utf8')

/** Stations between start and goal of the way that the card's solution learns. */
function between(folder: string): readonly number[] {
  const { programs } = JSON.parse(read(folder, 'solution.json')) as CardProgram
  const outline = Object.values(programs).flatMap((program) => learningIn(program) ?? [])[0]!
  const course = courseOf(outline, readMap(read(content, 'maps', outline.map, 'map.svg')).map!, 1)
  course.advance(outline.moves)
  return course.way().stations!.slice(1, -1)
}

/** What a child reads before it guesses: its card in the lab, and on paper. Headings and what is drawn are left out. */
function textsOf(folder: string): readonly string[] {
  const id = basename(folder).replace(/^\d+-/, '')
  const cards = globSync([join(folder, '*.md'), join(content, `materials/card/*-q-${id}/*.md`)])
  return cards.map((file) => read(file).replaceAll(/^(::|#).*$/gm, ''))
}

describe.each(folders)('the card in %s', (folder) => {
  test('names no station of the way that the child is to guess', () => {
    const way = between(folder)
    expect(way.length).toBeGreaterThan(1)
    const texts = textsOf(folder)
    expect(texts).toHaveLength(4)
    for (const text of texts) {
      const numbers = [...text.matchAll(/\d+/g)].map(([number]) => Number(number))
      expect(numbers.filter((number) => way.includes(number))).toEqual([])
    }
  })
})
