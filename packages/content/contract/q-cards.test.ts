import { courseOf } from '@botgarten/maps'
import { learningIn } from '@botgarten/programs'
import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, test } from 'vitest'
import { content } from '../files.ts'
import { textOf } from './there.ts'

const cards = content.cards.filter(({ bed }) => bed === 'q-learning').map(({ id }) => id)

/** Stations between start and goal of the way that the card's solution learns. */
function between(card: string): readonly number[] {
  const { programs } = content.program(card, 'solution')!
  const outline = Object.values(programs).flatMap((program) => learningIn(program) ?? [])[0]!
  const course = courseOf(outline, content.mapFile(outline.map)!, 1)
  course.advance(outline.moves)
  return course.way().states!.slice(1, -1)
}

/** What a child reads before it guesses: its card in the lab, and on paper. Headings and what is drawn are left out. */
function textsOf(card: string): readonly string[] {
  const folders = [content.cardFolder(card), content.itemFolder(`q-${card}`)]
  return folders.flatMap((folder) =>
    completeLanguages.map((language) => textOf(folder, `${language}.md`).replaceAll(/^(::|#).*$/gm, '')),
  )
}

describe.each(cards)('the card %s', (card) => {
  test('names no station of the way that the child is to guess', () => {
    const way = between(card)
    expect(way.length).toBeGreaterThan(1)
    const texts = textsOf(card)
    expect(texts).toHaveLength(4)
    for (const text of texts) {
      const numbers = [...text.matchAll(/\d+/g)].map(([number]) => Number(number))
      expect(numbers.filter((number) => way.includes(number))).toEqual([])
    }
  })
})
