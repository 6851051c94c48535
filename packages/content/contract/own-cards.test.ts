import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { kinds } from '@botgarten/lab'
import {
  isCardFile,
  ownKinds,
  parseCardFile,
  parseProject,
  playedFrom,
  writeCardFile,
  writeProject,
  type OwnCard,
  type OwnCardText,
  type Project,
} from '@botgarten/programs'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { cardProject } from '../index.ts'
import { choosable, draftOf, onlyBegun, tried } from '../ownCard.ts'

addBlocks(learning)

it('every kind that can be chosen is one that the lab knows, with the same numbers', () => {
  for (const [kind, { asks }] of Object.entries(ownKinds))
    expect([kind, Object.keys(asks).sort()]).toEqual([kind, [...(kinds[kind]?.needs ?? [])].sort()])
})

/** Cards of the house all of whose checks can be chosen. What learns by trying keeps tables, which no own card brings. */
const solvable = content.cards
  .filter(({ bed, chapter }) => (bed === 'network' || bed === 'drive') && chapter !== 'trying')
  .map(({ id }) => content.card(id)!)
  .filter(({ card }) => choosable(card.checks).length === card.checks.length)

/** A teacher's own project: a card's world with the program that solves it. */
function solvedProject(id: string): Project {
  const { card, world } = content.card(id)!
  return cardProject(world, card, content.program(id, 'solution')!, id)
}

const letters = (most: number) =>
  fc
    .string({ unit: 'grapheme', minLength: 1, maxLength: Math.floor(most / 4) })
    .map((text) => text.replaceAll('<', '‹').slice(0, most))
    .filter((text) => text.trim() !== '')
const words: fc.Arbitrary<OwnCardText> = fc.record({
  ...{ title: letters(40), story: letters(420), task: letters(140) },
  hints: fc.tuple(letters(240), letters(240), letters(240)),
})
const texts: fc.Arbitrary<OwnCard['text']> = fc.oneof(
  words.map((de) => ({ de })),
  words.map((en) => ({ en })),
  fc.tuple(words, words).map(([de, en]) => ({ de, en })),
)

/** A card that somebody makes: of one of the house, with words, places and minutes of their own. */
const made = fc
  .record({
    of: fc.constantFrom(...solvable),
    text: texts,
    minutes: fc.integer({ min: 1, max: 90 }),
    grades: fc.tuple(fc.integer({ min: 1, max: 6 }), fc.integer({ min: 6, max: 13 })),
    place: fc.nat(),
    whole: fc.boolean(),
    begun: fc.boolean(),
  })
  .map(({ of, text, minutes, grades, place, whole, begun }) => {
    const project = draftOf(solvedProject(of.card.id), 'Mine', 'en', of.card)
    const card = project.ownCard!
    const first = card.starts[place % card.starts.length]!
    const starts = [first, ...card.starts.filter((one) => one !== first)]
    // Rules decide there, whatever the knobs of the network beside them say.
    const start = begun || of.card.id === 'if-then' ? onlyBegun(project) : card.start!
    return { project: { ...project, ownCard: { ...card, text, minutes, grades, starts, start } }, whole }
  })

const floors = new Map<string, ReturnType<typeof content.floorOf>>()
function floorOf({ world }: Project) {
  const key = JSON.stringify([world.floor, world.areas, world.lines])
  const floor = floors.get(key) ?? content.floorOf(world)
  floors.set(key, floor)
  return floor
}

it('40 own cards are made, exported, opened and solved', () => {
  fc.assert(
    fc.property(made, fc.nat(), ({ project, whole }, at) => {
      const text = writeCardFile(playedFrom(project, whole))
      expect(isCardFile(JSON.parse(text))).toBe(true)
      const opened = parseCardFile(text)
      expect(opened).toEqual(JSON.parse(JSON.stringify(playedFrom(project, whole))))
      expect(parseCardFile(writeCardFile(opened))).toEqual(opened)
      // As it is kept on a device, and travels in a link.
      expect(parseProject(writeProject(opened))).toEqual(opened)
      const card = opened.ownCard!
      expect(card.solution !== undefined).toBe(whole)
      const start = card.starts[at % card.starts.length]!
      const floor = floorOf(opened)
      expect(tried(opened, project, card, { start, floor })).toEqual({ reached: true, solved: true })
      expect(tried(opened, opened, card, { start, floor }).reached).toBe(false)
    }),
    { numRuns: 40 },
  )
}, 240_000)

describe('a card of somebody else', () => {
  const project = draftOf(solvedProject('friendship'), 'Mine', 'en', content.card('friendship')!.card)
  const hints = ['One', 'Two', 'Three'] as const
  const text = { en: { title: 'Meet', story: 'A story.', task: 'Bo comes near.', hints } }
  const whole = playedFrom({ ...project, ownCard: { ...project.ownCard!, text } })

  it('begins with its knobs at 0 at its first place', () => {
    expect(whole.world.robots[0]!.pose).toEqual(content.card('friendship')!.card.starts[0])
    expect(JSON.stringify(Object.values(whole.brains)[0]!.weights)).not.toMatch(/[1-9]/)
    expect(whole).not.toHaveProperty('card')
  })

  it('can be made another one of: what children begin with stays, the solution is the program again', () => {
    const { ownCard } = playedFrom({ ...project, ownCard: { ...project.ownCard!, text } }, true)
    const again = draftOf({ ...whole, ownCard: ownCard! }, 'Again', 'en')
    expect(again.brains).toEqual(project.brains)
    expect(again.ownCard!.start!.brains).toEqual(whole.brains)
  })
})
