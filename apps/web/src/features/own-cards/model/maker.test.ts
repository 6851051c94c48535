import 'fake-indexeddb/auto'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { draftOf, knobsAtZero, onlyBegun } from '@botgarten/content/own-card'
import { lackOf, looksLikeTag, mostOfCard, ownKinds, type OwnCard, type Project } from '@botgarten/programs'
import { fitsWorld } from '@botgarten/programs/project'
import { paintFloor, type World } from '@botgarten/simulation'
import fc from 'fast-check'
import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { load } from '#storage/projects.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { CardMaker } from './maker.svelte.ts'

type Draft = Project & { readonly ownCard: OwnCard }

beforeAll(() => addBlocks(learning))
beforeEach(async () => {
  await freshDevice()
  screen()
})
const open: CardMaker[] = []
afterEach(() => {
  for (const maker of open.splice(0)) maker.close()
  vi.unstubAllGlobals()
})

const { card, world } = content.card('friendship')!
const solved = cardProject(world, card, content.program('friendship', 'solution')!, 'friendship')

function making(change: Partial<World> = {}, of = solved): CardMaker {
  const project = draftOf({ ...of, world: { ...of.world, ...change } }, 'Meet', 'en') as Draft
  const floor = paintFloor({ ...world, floor: { colour: '#FFFFFF' } })
  const maker = new CardMaker({ id: 'card-1', revision: 0, project, floor })
  open.push(maker)
  return maker
}

describe('words', () => {
  test('are written language by language; one in which nothing is written is gone', () => {
    const maker = making()
    maker.setText('de', { title: 'Treffen' })
    maker.setHint('de', 1, 'Schau hin.')
    expect(maker.textIn('de')).toMatchObject({ title: 'Treffen', story: '', hints: ['', 'Schau hin.', ''] })
    maker.setText('de', { title: '', hints: ['', '', ''] })
    expect(Object.keys(maker.card.text)).toEqual(['en'])
    expect(maker.textIn('de').hints).toEqual(['', '', ''])
  })

  test('never look like a tag, whatever is typed', () => {
    const maker = making()
    const text = fc.string({ unit: fc.constantFrom('<', '/', 'b', '!', '>', ' ', '?', '1') })
    fc.assert(
      fc.property(text, text, (story, hint) => {
        maker.setText('en', { title: story, story, task: story })
        maker.setHint('en', 2, hint)
        const words = maker.textIn('en')
        const all = [words.title, words.story, words.task, ...words.hints]
        expect(all.filter(looksLikeTag)).toEqual([])
        expect(words.story.replaceAll('‹', '<')).toBe(story)
      }),
    )
    maker.setText('en', { story: '1 < 2' })
    expect(maker.textIn('en').story).toBe('1 < 2')
  })

  test('give the card its name: of the language that is complete, else of the one that is begun', () => {
    const maker = making()
    maker.setText('en', { title: ' ' })
    expect([maker.title, maker.project.name]).toEqual(['', 'Meet'])
    maker.setText('de', { title: 'Treffen', story: 'S', task: 'T', hints: ['1', '2', '3'] })
    maker.setText('en', { title: 'Meeting' })
    expect([maker.title, maker.project.name]).toEqual(['Treffen', 'Treffen'])
    maker.setText('de', { hints: ['', '', ''] })
    maker.setText('en', { story: 'S', task: 'T', hints: ['1', '2', '3'] })
    expect(maker.title).toBe('Meeting')
  })
})

describe('start places', () => {
  test('are whole numbers inside of the world, with a heading below 360°', () => {
    const maker = making()
    const { width, height } = maker.world.size
    maker.setPlace(0, { x: 12.4, y: height + 50, heading: -90.2 })
    expect(maker.card.starts[0]).toEqual({ x: 12, y: height, heading: 270 })
    maker.setPlace(0, { x: width + 1, y: -3, heading: 720.4 })
    expect(maker.card.starts[0]).toEqual({ x: width, y: 0, heading: 0 })
  })

  test('are added where the robot stands, or next to the chosen one, and chosen', () => {
    const maker = making()
    const { x, y, heading } = maker.world.robots[0]!.pose
    maker.addPlace(true)
    expect(maker.card.starts[1]).toEqual({ x: Math.round(x), y: Math.round(y), heading })
    expect(maker.chosen).toBe(1)
    maker.setPlace(1, { x: 100, y: 90, heading: 45 })
    maker.addPlace(false)
    expect([maker.card.starts[2], maker.chosen]).toEqual([{ x: 120, y: 110, heading: 45 }, 2])
  })

  test('are eight at most and one at least', () => {
    const maker = making()
    for (let more = 0; more < 10; more += 1) maker.addPlace(true)
    expect([maker.card.starts.length, maker.chosen]).toEqual([mostOfCard.starts, 7])
    for (let more = 0; more < 10; more += 1) maker.removePlace(0)
    expect([maker.card.starts.length, maker.chosen]).toEqual([1, 0])
  })
})

describe('checks', () => {
  test('of every kind that is offered begin with numbers that fit the world', () => {
    const maker = making()
    expect(maker.kinds.length).toBeGreaterThan(5)
    for (const kind of maker.kinds) {
      maker.addCheck(kind)
      const [check] = maker.card.checks
      expect(Object.keys(check!.numbers).sort()).toEqual(Object.keys(ownKinds[kind]!.asks).sort())
      expect(check!.seconds).toBe(ownKinds[kind]!.lasts ? 5 : 0)
      for (const [name, asked] of Object.entries(ownKinds[kind]!.asks))
        if (typeof asked !== 'string') {
          expect(check!.numbers[name]).toBeGreaterThanOrEqual(asked[0])
          expect(check!.numbers[name]).toBeLessThanOrEqual(asked[1])
        }
      // The child chooses the other check.
      for (const [name, asked] of Object.entries(ownKinds[kind]!.asks))
        if (asked === 'check') expect(check!.numbers[name]).toBe('')
      expect([kind, fitsWorld(maker.card, maker.world)]).toEqual([kind, true])
      maker.removeCheck(check!.id)
    }
    expect(maker.card.checks).toEqual([])
  })

  test('are offered where the world has what they ask for', () => {
    const near = ['near', 'stays', 'neverTouches', 'turnsAway']
    const all = making().kinds
    expect(all).toEqual(expect.arrayContaining([...near, 'sings', 'turnsBack']))
    expect(making({ obstacles: [] }).kinds.filter((kind) => near.includes(kind))).toEqual([])
    const [robot] = world.robots
    const blind = { ...robot!, config: { ...robot!.config, sensors: {} } }
    const without = making({ robots: [blind] }).kinds
    expect(without.filter((kind) => ['sings', 'turnsBack', 'led', 'silent', 'rests'].includes(kind))).toEqual(
      [],
    )
    expect(without).toEqual(expect.arrayContaining(['near', 'arrives', 'cruises']))
    const sees = { ...blind.config, sensors: { 3: { kind: 'colour' } } } as unknown as typeof blind.config
    const coloured = making({ robots: [{ ...blind, config: sees }] }).kinds
    expect(coloured).toEqual(
      expect.arrayContaining(['led', 'speedOn', 'neverSees', 'says', 'silent', 'rests']),
    )
    expect(coloured).not.toContain('sings')
  })

  test('begin with places in the middle of the world, and numbers that a card of the house could have', () => {
    const maker = making({ size: { width: 400, height: 200 } })
    for (const kind of ['arrives', 'visits', 'near', 'rests', 'turnsAway']) maker.addCheck(kind)
    const [arrives, visits, near, rests, turnsAway] = maker.card.checks.map(({ numbers }) => numbers)
    expect(arrives).toMatchObject({ x: 200, y: 100, cm: 20, after: '' })
    // Half the height, at a quarter and three quarters of the width.
    expect(visits).toMatchObject({ points: '100 100, 300 100', cm: 20 })
    expect(near).toEqual({ obstacle: maker.world.obstacles[0]!.id, cm: 8 })
    expect(rests).toEqual({ light: 15, percent: 3 })
    expect(turnsAway).toMatchObject({ near: 60, far: 80 })
  })

  test('of speed begin with 5 to 50 %', () => {
    const maker = making()
    maker.addCheck('speedOn')
    expect(maker.card.checks[0]!.numbers).toMatchObject({ least: 5, most: 50 })
  })

  test('of one kind are told apart, and are five at most', () => {
    const maker = making()
    for (let more = 0; more < 7; more += 1) maker.addCheck('near')
    expect(maker.card.checks.map(({ id }) => id)).toEqual(['near', 'near2', 'near3', 'near4', 'near5'])
    maker.removeCheck('near2')
    maker.addCheck('near')
    expect(maker.card.checks.at(-1)!.id).toBe('near2')
  })

  test('are changed one by one', () => {
    const maker = making()
    maker.addCheck('near')
    maker.addCheck('arrives')
    const [near, arrives] = maker.card.checks
    maker.setCheck('arrives', { seconds: 9 })
    expect(maker.card.checks).toEqual([near, { ...arrives!, seconds: 9 }])
  })

  test('that counted after one that is removed count all the time', () => {
    const maker = making()
    maker.addCheck('near')
    maker.addCheck('arrives')
    maker.setCheck('arrives', { numbers: { ...maker.card.checks[1]!.numbers, after: 'near' } })
    maker.removeCheck('near')
    expect(maker.card.checks).toMatchObject([{ id: 'arrives', numbers: { after: '' } }])
  })
})

describe('how pupils begin', () => {
  test('is with knobs at zero where there is a network, with one block alone, or another program', () => {
    const maker = making()
    expect([maker.beginnings, maker.beginning]).toEqual([['zero', 'begun'], 'zero'])
    expect(maker.card.start).toEqual(knobsAtZero(solved))
    maker.beginWith('begun')
    expect([maker.beginning, maker.card.start]).toEqual(['begun', onlyBegun(solved)])
    const other = { programs: solved.programs, brains: {} }
    maker.beginWith(other)
    expect([maker.beginning, maker.card.start]).toEqual([null, other])
    maker.beginWith('zero')
    expect(maker.beginning).toBe('zero')
  })

  test('is never with knobs where the program has no network', () => {
    const begun = { ...solved, ...onlyBegun(solved) }
    const maker = making({}, begun)
    expect([maker.beginnings, maker.beginning]).toEqual([['begun'], 'begun'])
  })
})

test('wrong answers are eight at most, with short names', () => {
  const maker = making()
  for (let more = 0; more < 9; more += 1) maker.addWrong(`${more} <b ${'x'.repeat(60)}`, onlyBegun(solved))
  expect(maker.card.wrong).toHaveLength(mostOfCard.wrong)
  expect(maker.card.wrong![0]!.name).toBe(`0 ‹b ${'x'.repeat(35)}`)
  maker.removeWrong(0)
  expect(maker.card.wrong!.map(({ name }) => name[0])).toEqual(['1', '2', '3', '4', '5', '6', '7'])
})

test('every change is saved; what pupils get has no solution unless colleagues get it', async () => {
  const maker = making()
  maker.addCheck('near')
  maker.setText('en', { title: 'Meet', story: 'S', task: 'T', hints: ['1', '2', '3'] })
  await maker.autosave.flush()
  expect((await load('card-1'))?.project).toEqual(JSON.parse(JSON.stringify(maker.project)))
  expect(lackOf(maker.card)).toBeNull()
  expect(maker.played().ownCard!.solution).toBeUndefined()
  expect(maker.played().brains).toEqual(knobsAtZero(solved).brains)
  expect(maker.played(true).ownCard!.solution!.brains).toEqual(solved.brains)
})
