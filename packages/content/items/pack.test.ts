import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, test } from 'vitest'
import { content } from '../files.ts'
import { atGrade, codeOfAll, linesFor, printingOf, sidesIn, timesIn, whoGets } from './pack.ts'
import { readItemText } from '../schema/itemText.ts'

describe('how something is printed', () => {
  // The cover of lesson 3 for 24 children, as drawn in the design: 32 sheets of A4 with one page of answers.
  test.each([
    ['a plan of two pages', 'a4', 2, 1, { pages: 2, prints: 1, sheets: 1 }],
    ['six cards of one kind, two on a sheet', 'a5', 2, 6, { pages: 2, prints: 3, sheets: 3 }],
    ['a sheet for each of twelve pairs', 'a4', 1, 12, { pages: 1, prints: 12, sheets: 12 }],
    ['an exit check for 24, two on a sheet', 'a5', 1, 24, { pages: 1, prints: 12, sheets: 12 }],
    [
      'three cards for twelve pairs: the last one lies there twice',
      'a5',
      6,
      12,
      { pages: 4, prints: 12, sheets: 24 },
    ],
  ] as const)('%s', (_, paper, sides, times, printing) => {
    expect(printingOf(paper, sides, times)).toEqual(printing)
  })

  test('one card on A5 takes half a sheet of A4', () => {
    expect(printingOf('a5', 2, 6, false)).toEqual({ pages: 2, prints: 6, sheets: 3 })
  })

  test('how often follows from the children, until somebody says how often', () => {
    expect(timesIn({ of: 'item:a', for: 'pair' }, 24)).toBe(12)
    expect(timesIn({ of: 'item:a', for: 'pair', times: 5 }, 24)).toBe(5)
  })

  test('answers come last, all else as the plan has it', () => {
    const plan = {
      copies: ['a', 'answers', 'b'].map((id) => ({ of: `item:${id}`, for: 'teacher' as const })),
    }
    const lines = linesFor(plan as never, (of) => of === 'item:answers')
    expect(lines.map(({ of }) => of)).toEqual(['item:a', 'item:b', 'item:answers'])
  })

  test('for whom something is printed follows from who works with it', () => {
    const pupils = { audience: 'pupils', kind: 'sheet' } as const
    expect(whoGets({ ...pupils, social: 'alone' })).toBe('child')
    expect(whoGets({ ...pupils, social: 'pairs' })).toBe('pair')
    expect(whoGets({ ...pupils, social: 'groups' })).toBe(4)
    expect(whoGets({ ...pupils, social: 'pairs', kind: 'slides' })).toBe('teacher')
    expect(whoGets({ ...pupils, social: 'pairs', audience: 'teachers' })).toBe('teacher')
  })

  test('an item has a side more than it has turns, or as many as it says', () => {
    const text = readItemText('# A\n\nOne.\n\n::page\n\nTwo.')
    const sides = { de: 9, en: 7 }
    expect([sidesIn({}, text, 'de'), sidesIn({ sides: 9 }, text, 'de')]).toEqual([2, 9])
    expect([sidesIn({ sides }, text, 'de'), sidesIn({ sides }, text, 'en')]).toEqual([9, 7])
  })
})

describe('a sheet with reading levels', () => {
  const leveled = content.items.filter(({ levels }) => levels)
  const there = new Map(content.items.map((item) => [item.id, item]))

  test('is one of its own for each level, with its letter and the grades of that level', () => {
    expect(leveled.map(codeOfAll)).toEqual(['3.1', '3.2', '2.1', '2.2', '4.4', '5.3'])
    for (const { id, code, levels } of leveled) {
      expect(code).toMatch(/b$/)
      for (const [level, grades] of Object.entries(levels!))
        expect(there.get(`${id}-${level}`)).toMatchObject({ grades, code: code!.replace(/b$/, level) })
    }
  })

  test('is the one for the grade of a class, wherever there is one', () => {
    for (const item of leveled)
      for (let grade = 3; grade <= 12; grade++) {
        const [from, to] = there.get(atGrade(item, grade))!.grades
        expect([from <= grade, grade <= to]).toEqual([true, true])
      }
    expect(atGrade({ id: 'a', levels: { c: [10, 12] } }, 3)).toBe('a')
    expect(atGrade({ id: 'a' }, 3)).toBe('a')
    expect(atGrade({ id: 'a', levels: { a: [3, 4] } }, null)).toBe('a')
  })
})

describe('packs that belong to no lesson', () => {
  test('have a name in every language, and copy what is there', () => {
    for (const { title, copies } of content.packs) {
      expect(Object.keys(title)).toEqual(expect.arrayContaining([...completeLanguages]))
      const names = copies.map(({ of }) => of.replace('item:', ''))
      expect(names.filter((name) => content.items.every(({ id }) => id !== name))).toEqual([])
    }
  })

  test('for a day without a network nothing needs a screen', () => {
    const { copies } = content.packs.find(({ id }) => id === 'no-network')!
    const codes = copies.map(({ of }) => content.items.find(({ id }) => of === `item:${id}`)?.code)
    expect(codes).toEqual(expect.arrayContaining(['K 3', 'K 5', 'K 6', 'K 7']))
  })
})
