import { describe, expect, test } from 'vitest'
import { content } from '../files.ts'
import { textOf, wordsIn } from './there.ts'

const plain = (text: string) => text.replaceAll('’', "'")

/** Data about a child, as both letters name them. */
const named = {
  de: [
    /Spitzname/,
    /[Dd]rei Bilder/,
    /letzten Fassungen/,
    /Galerie der Klasse gezeigt/,
    /weniger als fünf/,
    /Fragebogen/,
  ],
  en: [
    /nickname/,
    /[Tt]hree pictures/,
    /last versions/,
    /class's gallery/,
    /fewer than five/,
    /questionnaire/,
  ],
}

describe.each(['de', 'en'] as const)('the letter to parents on paper, in %s', (language) => {
  const letter = plain(textOf(content.itemFolder('letter-to-parents'), `${language}.md`))
  const ofClass = wordsIn(language, 'teacher')['parents']!

  test.each(named[language])('names %s, as the letter of a class does', (data) => {
    expect(ofClass['kept']).toMatch(data)
    expect(letter).toMatch(data)
  })

  test('promises the deletion in the same words', () => {
    expect(letter).toContain(ofClass['until']!.replace('{day}', '______________'))
  })
})
