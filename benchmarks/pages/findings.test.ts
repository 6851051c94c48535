import { expect, test } from 'vitest'
import { contrast, laidOver } from './contrast.ts'
import { exceptionFor } from './exceptions.ts'
import { findingsIn } from './files.ts'
import { findingsOn } from './findings.ts'
import type { SeenPaper, SeenPart, SeenText } from './seen.ts'
import { strangers } from './strangers.ts'

const leaf = { left: 0, top: 0, right: 500, bottom: 700 }
const least = { text: 7.5, drawn: 7 }

let number = 0
const at = (left: number, top: number, width: number, height: number) => ({
  left,
  top,
  right: left + width,
  bottom: top + height,
})
const text = (given: Partial<SeenText> = {}): SeenText => ({
  text: 'Bo fährt',
  box: at(20, 20, 80, 20),
  of: (number += 1),
  home: 0,
  points: 12,
  bold: false,
  drawn: false,
  language: 'de',
  colour: [58, 42, 32, 1],
  below: [[[255, 255, 255, 1]]],
  coveredBy: null,
  within: [leaf],
  ...given,
})
const part = (given: Partial<SeenPart> = {}): SeenPart => ({
  name: 'figure',
  box: at(20, 100, 200, 100),
  home: 0,
  inside: [],
  marks: 5,
  within: [leaf],
  ...given,
})
const paper = (given: Partial<SeenPaper>): SeenPaper => ({
  language: 'de',
  texts: [],
  parts: [],
  names: [],
  ...given,
})
const kindsOn = (given: Partial<SeenPaper>) => findingsOn(paper(given), least).map(({ kind }) => kind)

test('a page in order has no findings', () => {
  expect(kindsOn({ texts: [text(), text({ box: at(20, 38, 80, 20) })], parts: [part()] })).toEqual([])
})

test('lines over each other overlap, lines of one text and of two sides do not', () => {
  const below = { box: at(60, 26, 80, 20) }
  expect(kindsOn({ texts: [text(), text(below)] })).toEqual(['overlap'])
  expect(kindsOn({ texts: [text({ of: 0 }), text({ ...below, of: 0 })] })).toEqual([])
  expect(kindsOn({ texts: [text(), text({ ...below, home: 1 })] })).toEqual([])
})

test('what is painted over is an overlap, and so are two pictures, unless one is in the other', () => {
  expect(kindsOn({ texts: [text({ coveredBy: '<rect>' })] })).toEqual(['overlap'])
  expect(kindsOn({ parts: [part(), part({ name: 'img' })] })).toEqual(['overlap'])
  expect(kindsOn({ parts: [part(), part({ name: 'img', inside: [0] })] })).toEqual([])
})

test('words and pictures beyond their box are cut', () => {
  expect(kindsOn({ texts: [text({ box: at(460, 20, 80, 20) })] })).toEqual(['cut'])
  expect(kindsOn({ parts: [part({ box: at(20, 650, 100, 100) })] })).toEqual(['cut'])
})

test('a box with nothing in it, or without height, is empty', () => {
  expect(kindsOn({ parts: [part({ marks: 0 })] })).toEqual(['empty'])
  expect(kindsOn({ parts: [part({ box: at(20, 20, 200, 0) })] })).toEqual(['empty'])
})

test('words of the other language are found, in names of pictures as well', () => {
  expect(strangers('Turn the knob', 'de')).toEqual(['the'])
  expect(strangers('Dreh den Knopf und fahr', 'en')).toEqual(['und'])
  expect(strangers('Bo hat in der Hand was, also will man die Bahn', 'de')).toEqual([])
  expect(strangers('What was in the bad hat? The man will die', 'en')).toEqual([])
  expect(strangers('https://botgarten.example.org/lab/all-the-same CC BY 4.0', 'de')).toEqual([])
  expect(kindsOn({ texts: [text({ text: 'Turn the knob' })] })).toEqual(['language'])
  expect(kindsOn({ texts: [text({ text: 'Turn the knob', language: 'en' })] })).toEqual([])
  expect(kindsOn({ names: [{ text: 'A map of the town', language: 'de' }] })).toEqual(['language'])
})

test('pale letters are found by their luminance; large ones may be paler; on a picture nobody knows', () => {
  const pale = { colour: [140, 140, 140, 1] as const }
  expect(kindsOn({ texts: [text(pale)] })).toEqual(['pale'])
  expect(kindsOn({ texts: [text({ ...pale, points: 20 })] })).toEqual([])
  expect(kindsOn({ texts: [text({ ...pale, below: [null] })] })).toEqual([])
  expect(kindsOn({ texts: [text({ colour: [0, 0, 0, 0.3] })] })).toEqual(['pale'])
})

test('letters may be a little smaller in a drawing than in a text', () => {
  expect(kindsOn({ texts: [text({ points: 7.2 })] })).toEqual(['small'])
  expect(kindsOn({ texts: [text({ points: 7.2, drawn: true })] })).toEqual([])
  expect(kindsOn({ texts: [text({ points: 6.8, drawn: true })] })).toEqual(['small'])
})

test('contrast is as WCAG has it, and layers let through what lies below', () => {
  expect(contrast([0, 0, 0], [255, 255, 255])).toBeCloseTo(21)
  expect(contrast([118, 118, 118], [255, 255, 255])).toBeCloseTo(4.54, 2)
  expect(laidOver([[0, 0, 0, 0.5]])).toEqual([127.5, 127.5, 127.5])
})

const page = {
  width: 210,
  height: 297,
  text: 'Bo',
  links: [],
  missingFonts: [],
  outside: [],
  marks: 80,
  headings: [1, 2, 2, 3],
  figures: 1,
  silentFigures: 0,
}
const file = { title: 'Bo', language: 'de', tagged: true, outline: ['Bo'], pages: [page] }

test('a file says its language and its title, and its figures have words', () => {
  const wrongIn = (given: object) => findingsIn({ ...file, ...given }, 'de').map(({ what }) => what)
  const onPage = (given: object) => wrongIn({ pages: [{ ...page, ...given }] })
  expect(wrongIn({})).toEqual([])
  expect(wrongIn({ tagged: false, language: 'en', title: '', outline: [] })).toHaveLength(4)
  expect(onPage({ headings: [2] })).toEqual(['no first heading', '1 levels of headings are skipped'])
  expect(onPage({ headings: [1, 3] })).toEqual(['1 levels of headings are skipped'])
  expect(onPage({ silentFigures: 2 })).toEqual(['2 figures without words'])
  expect(onPage({ missingFonts: ['Nunito'], outside: ['Rad'], marks: 3 })).toHaveLength(3)
})

test('an exception holds for its items, its kind and its words alone', () => {
  const known = [{ items: ['q-map'], kind: 'small', what: /^“7”/, because: 'stations' } as const]
  const found = { kind: 'small', what: '“7” 6.0 pt' } as const
  expect(exceptionFor('q-map', found, known)).toBe(known[0])
  expect(exceptionFor('q-flow', found, known)).toBeUndefined()
  expect(exceptionFor('q-map', { ...found, kind: 'cut' }, known)).toBeUndefined()
  expect(exceptionFor('q-map', { ...found, what: '“8” 6.0 pt' }, known)).toBeUndefined()
})
