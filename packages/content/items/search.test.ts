import fc from 'fast-check'
import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, test } from 'vitest'
import { content } from '../files.ts'
import { readItemText } from '../schema/itemText.ts'
import { folded, passagesOf, scoreOf, search, type Synonyms } from './search.ts'

const text = readItemText(`# Drehknöpfe

Zwei Räder, vier Knöpfe.

## Freundschaft

Bo bleibt stehen.

::net{card=friendship}

| Frage | Antwort |
| ----- | ------- |
| Wie viel? | **20** |

## Ende

### Notes

Nimm 3.12, nicht mehr.
`)
const passages = passagesOf({ code: 'NN 5' }, text, 'Arbeitsblatt', (card) => `Karte ${card}`)
const synonyms: Synonyms = [
  ['Knopf', 'Gewicht'],
  ['ohne Strom', 'Arbeitsblatt'],
]
const found = (query: string) => search(passages, query, synonyms).map(({ words }) => words)

describe('a search', () => {
  test('finds words in title, kind, sections, text, tables, notes and names of cards', () => {
    expect(found('drehknöpfe')).toEqual(['Drehknöpfe'])
    expect(found('arbeitsb')).toEqual(['Arbeitsblatt'])
    expect(found('FREUNDSCHAFT')).toEqual(['Freundschaft'])
    expect(found('stehen')).toEqual(['Bo bleibt stehen.'])
    expect(found('friendship')).toEqual(['Karte friendship'])
    expect(found('20')).toEqual(['20'])
    expect(found('nimm')).toEqual(['Nimm 3.12, nicht mehr.'])
    expect(found('Topf')).toEqual([])
  })

  test('finds a code however it is typed, and no other number that begins like it', () => {
    for (const query of ['NN 5', 'nn5', ' Nn  5']) expect(found(query)).toEqual(['NN 5'])
    expect(found('3.1')).toEqual([])
    expect(found('NN 55')).toEqual([])
  })

  test('finds umlauts with and without their dots, and long words inside others', () => {
    expect(found('knopfe')).toEqual(['Drehknöpfe', 'Zwei Räder, vier Knöpfe.'])
    // A short one begins a word: "in" is not in "eins".
    expect(found('ende')).toEqual(['Ende'])
    expect(found('ad')).toEqual([])
  })

  test('finds what is called by another word', () => {
    expect(search([{ place: 'title', words: 'Mein Knopf', section: 0 }], 'gewicht', synonyms)).toHaveLength(1)
    expect(found('ohne strom')).toEqual(['Arbeitsblatt'])
  })

  test('wants every word of a query, and puts what stands in the title first', () => {
    expect(found('bo freundschaft')).toEqual(['Freundschaft', 'Bo bleibt stehen.'])
    expect(found('bo topf')).toEqual([])
    expect(scoreOf(search(passages, 'drehknöpfe'))).toBeGreaterThan(scoreOf(search(passages, 'freundschaft')))
  })

  test('marks letters of what was found, whatever is looked for', () => {
    fc.assert(
      fc.property(fc.string(), (query) => {
        for (const { words, marks } of search(passages, query, synonyms))
          for (const [from, to] of marks) {
            expect(from).toBeLessThan(to)
            expect(to).toBeLessThanOrEqual(words.length)
          }
      }),
    )
    fc.assert(
      fc.property(fc.string({ unit: 'grapheme' }), (words) => {
        expect(folded(words)).toHaveLength(words.length)
      }),
    )
    // U+FAD0 is one unit, and two once it is taken apart.
    expect(folded('\uFAD0')).toBe('\uFAD0')
  })
})

describe('synonyms of the library', () => {
  test.each(completeLanguages)('in "%s" each word stands in one group', (language) => {
    const words = content.itemTexts(language).synonyms.flat().map(folded)
    expect(words.filter((word, at) => words.indexOf(word) !== at)).toEqual([])
    expect(words.length).toBeGreaterThan(40)
  })
})
