import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, it, test } from 'vitest'
import { content } from '../files.ts'
import { planParts, timesOf } from '../items/plan.ts'
import { readItemText } from '../schema/itemText.ts'
import type { ItemNode, Section } from '../schema/itemTypes.ts'
import { plainOf } from '../schema/markdown.ts'
import { expectTrue, named } from './claims.ts'
import { textOf, there } from './there.ts'

const plans = content.items.flatMap((item) => (item.plan ? [{ ...item, plan: item.plan }] : []))
const textIn = (id: string, language: string) =>
  readItemText(textOf(content.itemFolder(id), `${language}.md`))

/** The longest sentence that a teacher reads out. */
const longestSaid = 25
const wordsIn = (text: string) => text.split(/\s+/).filter((word) => /\p{L}|\d/u.test(word)).length

test('every item with a code has one of its own', () => {
  const codes = content.items.flatMap(({ code }) => code ?? [])
  expect(codes.filter((code, at) => codes.indexOf(code) !== at)).toEqual([])
})

test('what is a lesson plan says when what happens', () => {
  for (const item of content.items) expect(item.kind === 'plan').toBe(item.plan !== undefined)
})

describe.each(plans)('the plan $id', ({ id, code, minutes, plan }) => {
  it('has the code of its lesson', () => {
    expect(code).toBe(`P ${plan.lesson}`)
  })

  it('takes exactly its time', () => {
    expect(plan.steps.reduce((sum, step) => sum + step.minutes, 0)).toBe(minutes)
    expect(plan.steps.length).toBeGreaterThanOrEqual(5)
    expect(plan.steps.length).toBeLessThanOrEqual(7)
  })

  it('copies what is there, itself once', () => {
    const { items, cards } = there()
    for (const { of } of plan.copies) {
      const [kind, target] = of.split(':') as [string, string]
      expect((kind === 'item' ? items : new Set(cards.keys())).has(target), of).toBe(true)
    }
    expect(plan.copies.filter(({ of }) => of === `item:${id}`)).toHaveLength(1)
  })

  describe.each(completeLanguages)('in "%s"', (language) => {
    const parts = planParts(textIn(id, language), plan)
    const of = (section: Section, type: ItemNode['type']) => section.body.filter((node) => node.type === type)

    it('has two or three goals, at most five things to prepare, four or five mistakes', () => {
      const items = (section: Section) =>
        of(section, 'list').flatMap((node) => ('children' in node ? node.children : []))
      expect([2, 3]).toContain(items(parts.goals).length)
      expect(items(parts.prepare).length).toBeLessThanOrEqual(5)
      const [mistakes] = of(parts.wrong, 'table') as Extract<ItemNode, { type: 'table' }>[]
      expect(mistakes!.head).toHaveLength(3)
      expect([4, 5]).toContain(mistakes!.rows.length)
    })

    it('asks one question a goal at the end, each with its answer', () => {
      const goals = of(parts.goals, 'list').flatMap((node) => ('children' in node ? node.children : []))
      const [check] = of(parts.check, 'table') as Extract<ItemNode, { type: 'table' }>[]
      const asked = check!.rows.map((row) => row.map((cell) => cell.map(plainOf).join('')))
      expect(asked.map(([, , goal]) => goal)).toEqual(goals.map((_, at) => String(at + 1)))
      for (const [question, answer] of asked) expect([question, answer]).not.toContain('')
    })

    it('says nothing that is longer than is read out in one breath', () => {
      for (const { body } of parts.steps)
        for (const said of body.filter(({ type }) => type === 'blockquote'))
          expect(wordsIn(plainOf(said)), plainOf(said)).toBeLessThanOrEqual(longestSaid)
    })

    it('says in each step what to say, and what the double lesson does then', () => {
      for (const { title, body, notes } of parts.steps) {
        expect(
          body.some(({ type }) => type === 'blockquote'),
          title,
        ).toBe(true)
        expect(notes.length > 0, title).toBe(plan.double !== null)
      }
    })

    it('explains the matter in 70 words or so', () => {
      const words = wordsIn(of(parts.minute, 'paragraph').map(plainOf).join(' '))
      expect(words).toBeLessThanOrEqual(100)
    })

    it('links all that is copied, but itself', () => {
      const all = JSON.stringify(textIn(id, language))
      for (const { of: target } of plan.copies)
        if (target !== `item:${id}` && !target.startsWith('item:solutions'))
          expect(all).toContain(`"${target}"`)
    })
  })

  test.each(plan.claims.map(named))('%s', (_, claim) => expectTrue(claim))
})

test('a class of 24, in pairs, or four to a card', () => {
  expect(timesOf({ of: 'item:a', for: 'teacher' }, 24)).toBe(1)
  expect(timesOf({ of: 'item:a', for: 'child' }, 24)).toBe(24)
  expect(timesOf({ of: 'item:a', for: 'pair' }, 25)).toBe(13)
  expect(timesOf({ of: 'card:a', for: 4 }, 24)).toBe(6)
})
