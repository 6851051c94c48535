import { readFileSync } from 'node:fs'
import { openMap } from '@botgarten/maps/own'
import { readMap } from '@botgarten/maps'
import {
  bestMoves,
  circleOf,
  isMended,
  learnIn,
  offered,
  provedOf,
  settingsOf,
  untouched,
  worldOf,
} from '@botgarten/maps/zoo'
import { languagesOf } from '@botgarten/messages/folder'
import { sample } from '@botgarten/numbers/testing'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { gradeOf } from '../items/readability.ts'
import { readCage } from '../schema/cage.ts'
import { readCageText } from '../schema/cageText.ts'
import { textOf } from './there.ts'

const seeds = sample(
  Array.from({ length: 100 }, (_, index) => index + 1),
  5,
)

// Every cage is held to the same rules merely because its folder is there.
describe.each(content.cages.map((one) => [one.cage.id, one] as const))(
  'the cage %s',
  (id, { cage, text }) => {
    const svg = readFileSync(content.mapOfCage(id), 'utf8')
    const map = readMap(svg).map!
    const start = untouched(cage)

    it('has a map that the learner reads and the map designer opens', () => {
      expect(readMap(svg)).toMatchObject({ problems: [], warnings: [] })
      expect(map).toMatchObject({ id, start: cage.start, goal: cage.goal })
      expect(openMap(svg, id).map).toMatchObject({ kind: 'roads', start: cage.start })
    })

    it('claims what value iteration proves at both discount factors', () => {
      expect(provedOf(cage, map, start)).toEqual(cage.claim)
    })

    it('names the stations between which the best behaviour goes on for ever', () => {
      if (!cage.circle) return
      const world = worldOf(cage, map, start, offered.aLot)
      expect(circleOf(world, bestMoves(world, offered.aLot))).toEqual(cage.circle)
    })

    it('is mended by its solution at both discount factors, and by nothing that was there before', () => {
      expect(provedOf(cage, map, cage.solution)).toEqual({ aLot: 'wish', aLittle: 'wish' })
      expect(isMended(cage, map, start)).toBe(cage.claim.aLot === 'wish' && cage.claim.aLittle === 'wish')
    })

    it('one that is safe is safe at every setting', () => {
      if (cage.claim.aLot !== 'wish') return
      expect(settingsOf(cage.mend).filter((setting) => !isMended(cage, map, setting))).toEqual([])
    })

    it('Bo learns with its own setting what is claimed, and after the mend what is wished', () => {
      expect(cage.setting.gamma).toBe(offered.aLot)
      const outcomes = seeds.map((seed) => [
        learnIn(cage, map, start, seed).outcome,
        learnIn(cage, map, cage.solution, seed).outcome,
      ])
      expect(outcomes).toEqual(seeds.map(() => [cage.claim.aLot, 'wish']))
    })

    it.each(languagesOf(text))(
      'has all its words in "%s", as simple as its youngest reader needs them',
      (language) => {
        const { pay, options, hints, ...words } = text[language]!
        expect(pay).toHaveLength(cage.pay.length)
        expect(Object.keys(options)).toEqual(
          'options' in cage.mend ? cage.mend.options.map((one) => one.id) : [],
        )
        expect(hints.length).toBeGreaterThan(1)
        const sentences = [words.title, words.wish, words.soundsRight, words.why, words.mend, words.happened]
        for (const sentence of sentences) expect(sentence).toMatch(/\S/)
        const all = [...sentences, ...pay, ...Object.values(words.does), ...Object.values(options), ...hints]
        expect(gradeOf(all.join('\n'), language) ?? 0).toBeLessThanOrEqual(4)
      },
    )
  },
)

describe('the zoo', () => {
  it('has at least eight cages, one of them safe', () => {
    expect(content.cages.length).toBeGreaterThanOrEqual(8)
    expect(content.cages.filter(({ cage }) => cage.claim.aLot === 'wish')).toHaveLength(1)
  })

  it('tells its cages apart by title and wish, in every language', () => {
    for (const language of ['de', 'en'])
      for (const part of ['title', 'wish'] as const) {
        const all = content.cages.map(({ text }) => text[language]![part])
        expect(new Set(all).size).toBe(all.length)
      }
  })

  it('finds a tie at the fountain with 18: the school and walking to and fro are both worth 50', () => {
    const { cage } = content.cages.find(({ cage: one }) => one.id === 'fountain')!
    const map = readMap(readFileSync(content.mapOfCage('fountain'), 'utf8')).map!
    const at = (reward: number) => provedOf(cage, map, reward).aLot
    expect([17, 18, 19].map(at)).toEqual(['wish', 'tie', 'never'])
  })

  it('names a rule that is not there', () => {
    const { cage } = content.cages.find(({ cage: one }) => one.id === 'fountain')!
    expect(() => readCage({ ...cage, solution: 99 })).toThrow('no such setting')
    expect(() => readCage({ ...cage, mend: { ...cage.mend, rule: 7 } })).toThrow()
  })

  it('names the section that its words lack', () => {
    const text = textOf('zoo/02-fountain/en.md')
    expect(readCageText(text).wish).toMatch(/\S/)
    expect(() => readCageText(text.replace('## Wish', '## Dream'))).toThrow(
      new SyntaxError('The section "Wish" is missing.'),
    )
  })

  it('names sources of 1900 or later', () => {
    const { cage } = content.cages[0]!
    const from = (year: number) => readCage({ ...cage, source: { ...cage.source, year } })
    expect(from(1900).source.year).toBe(1900)
    expect(() => from(1899)).toThrow(expect.objectContaining({ name: 'ValiError' }))
  })
})
