import fc from 'fast-check'
import { expect, test } from 'vitest'
import { birds, merged, readAnswer, readAnswersFile, readPaper, writeAnswersFile } from './file.ts'
import { nothingReleased, released } from './release.ts'
import { talliesOf } from './tally.ts'
import { answersOf, chanceOf, columns } from './testing/answers.ts'

const read = (text: string) => readAnswersFile(JSON.parse(text))
const byId = (a: { readonly id: string }, b: { readonly id: string }) => (a.id < b.id ? -1 : 1)

test('a file holds all answers, in another order', () => {
  fc.assert(
    fc.property(answersOf(['before', 'after']), (answers) => {
      const back = read(writeAnswersFile(answers, chanceOf(2)))
      expect([...back].sort(byId)).toEqual([...answers].sort(byId))
      expect(merged(answers, back)).toHaveLength(answers.length)
    }),
  )
})

test('what is no file of answers is refused by its place', () => {
  const [answer] = fc.sample(answersOf(['after']), { numRuns: 50, seed: 1 }).flat()
  const file = (over: object) => ({ botgarten: 'answers', version: 1, answers: [{ ...answer, ...over }] })
  expect(() => readAnswersFile(file({}))).not.toThrow()
  for (const over of [
    { grade: 13 },
    { code: 'dodo-417' },
    { code: 'owl-99' },
    { day: 'today' },
    { nickname: 'Fox' },
  ])
    expect(() => readAnswersFile(file(over))).toThrow()
})

test('every bird that a child can choose begins a code', () => {
  const [answer] = fc.sample(answersOf(['after']), { numRuns: 50, seed: 1 }).flat()
  const codes = birds.map((bird) => `${bird}-100`)
  expect(new Set(codes).size).toBe(24)
  for (const code of codes) expect(readAnswer({ ...answer, code }).code).toBe(code)
})

test('counts from paper are of five to a thousand sheets', () => {
  const paper = (n: number) => ({ form: 'after', bands: ['5-6'], n, counts: { glad: [n] }, open: {} })
  for (const n of [5, 1000]) expect(readPaper(paper(n))).toEqual(paper(n))
  for (const n of [4, 1001]) expect(() => readPaper(paper(n))).toThrow()
})

/** A file with one letter changed, taken out or doubled. */
const broken = (text: string, chance: () => number) => {
  const at = Math.floor(chance() * text.length)
  const letter = String.fromCharCode(32 + Math.floor(chance() * 95))
  const put = [letter, '', text[at]! + letter][Math.floor(chance() * 3)]!
  return text.slice(0, at) + put + text.slice(at + 1)
}

test('2,000 damaged files of answers: each is refused or is one', () => {
  const files = fc.sample(answersOf(['after']), { numRuns: 20, seed: 1 })
  for (let seed = 0; seed < 2000; seed++) {
    const chance = chanceOf(seed)
    const text = broken(writeAnswersFile(files[seed % files.length]!, chance), chance)
    try {
      const back = read(text)
      const release = released(nothingReleased, back, ['after'], chance)
      talliesOf('after', columns, { answers: back, release, paper: [] })
    } catch (cause) {
      expect(['ValiError', 'SyntaxError']).toContain((cause as Error).name)
    }
  }
})
