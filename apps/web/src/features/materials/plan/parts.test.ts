import { readItemText } from '@botgarten/content/items'
import { describe, expect, test } from 'vitest'
import { linesOf, paragraphsOf, titleOfStep, withPictures } from './parts.ts'

const bodyOf = (markdown: string) => readItemText(`# A\n\n${markdown}`).lead

describe('a step of a plan', () => {
  test('what is quoted is said, what is listed is expected, what begins with emphasis is a note', () => {
    const lines = linesOf(
      bodyOf('> “Look!”\n\n- They look.\n- They laugh.\n\n*Board* Write it.\n\nThen go on.'),
    )
    expect(lines.map(({ kind, name }) => name ?? kind)).toEqual(['say', 'expect', 'expect', 'Board', 'plain'])
    expect(lines.map(({ words }) => JSON.stringify(words))).toEqual([
      expect.stringContaining('“Look!”'),
      expect.stringContaining('They look.'),
      expect.stringContaining('They laugh.'),
      expect.stringContaining(' Write it.'),
      expect.stringContaining('Then go on.'),
    ])
  })

  test('a question stands in a paragraph with its answer, and with what is handed out before', () => {
    const lines = linesOf(bodyOf('Hand it out.\n\n> “A?”\n\n- B.\n\n> “C?”\n\n- D.\n\n*Board* E.\n\nF.'))
    expect(paragraphsOf(lines).map((all) => all.map(({ kind }) => kind).join(' '))).toEqual([
      'plain say expect',
      'say expect',
      'note',
      'plain',
    ])
  })

  test('its title says after a dot what it needs', () => {
    expect(titleOfStep('Look back · board')).toEqual(['Look back', 'board'])
    expect(titleOfStep('Look back')).toEqual(['Look back', ''])
  })
})

test('words stand beside pictures, each with what is below it', () => {
  const { words, pictures } = withPictures(
    bodyOf('One.\n\n::scene{card=fear}\n\nTwo.\n\n::scene{card=friendship}\n\nThree.'),
  )
  expect(words).toHaveLength(1)
  expect(pictures.map(({ below }) => below.length)).toEqual([1, 1])
  expect(withPictures(bodyOf('One.'))).toEqual({ words: bodyOf('One.'), pictures: [] })
})
