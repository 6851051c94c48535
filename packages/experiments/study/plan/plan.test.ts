import * as fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { orderOf, williams } from './orders.ts'
import { PlanError, readPlan, writePlan, type StudyPlan } from './plan.ts'
import { pseudonymOf, readPseudonym } from './pseudonym.ts'

const plan: StudyPlan = {
  ...{ botgarten: 'study', version: 1, id: 'autumn', title: 'Autumn', seed: 7, groups: 6, children: 5 },
  modules: [
    { id: 'net', title: 'Neural network', cards: ['friendship', 'fear'] },
    { id: 'q', title: 'Learning by trying', cards: ['q-city'] },
    { id: 'groups', title: 'Sorting', cards: ['free'] },
  ],
  ...{ order: 'balanced', level: 'plain', maps: ['city'], log: true, word: 'Kiesel7' },
}

describe('a Williams square', () => {
  it.each([2, 3, 4, 5, 6, 7, 8])(
    'of %i has each at every place, and after every other one, equally often',
    (n) => {
      const rows = williams(n)
      const places = new Map<string, number>()
      const after = new Map<string, number>()
      for (const row of rows)
        row.forEach((one, at) => {
          places.set(`${one} at ${at}`, (places.get(`${one} at ${at}`) ?? 0) + 1)
          if (at > 0) after.set(`${row[at - 1]} ${one}`, (after.get(`${row[at - 1]} ${one}`) ?? 0) + 1)
        })
      expect([places.size, new Set(places.values()).size]).toEqual([n * n, 1])
      expect([after.size, new Set(after.values()).size]).toEqual([n * (n - 1), 1])
    },
  )

  it('of four is the one in the textbooks', () => {
    expect(williams(4)).toEqual([
      [0, 1, 3, 2],
      [1, 2, 0, 3],
      [2, 3, 1, 0],
      [3, 0, 2, 1],
    ])
  })
})

describe('the order of modules', () => {
  it('is balanced in every block of groups, equal for all in one, and the same for the same seed', () => {
    fc.assert(
      fc.property(fc.integer({ min: 1, max: 7 }), fc.nat(), fc.nat(5), (n, seed, block) => {
        const modules = Array.from({ length: n }, (_, at) => `m${at}`)
        const { length } = williams(n)
        const orders = Array.from({ length }, (_, at) =>
          orderOf(modules, 'balanced', seed, block * length + at + 1),
        )
        for (const order of orders) expect(order.toSorted()).toEqual(modules)
        const firsts = Map.groupBy(orders, ([first]) => first)
        expect(new Set([...firsts.values()].map((all) => all.length)).size).toBe(1)
        expect(new Set(orders.map((order) => order.join())).size).toBe(n === 1 ? 1 : length)
        expect(orderOf(modules, 'balanced', seed, block + 1)).toEqual(
          orderOf(modules, 'balanced', seed, block + 1),
        )
      }),
      { seed: 22 },
    )
  })

  it('of chance is another one for other groups, and stands as it is where it is fixed', () => {
    const modules = ['a', 'b', 'c', 'd']
    const drawn = new Set(Array.from({ length: 99 }, (_, at) => orderOf(modules, 'random', 1, at + 1).join()))
    expect(drawn.size).toBeGreaterThan(15)
    expect(orderOf(modules, 'fixed', 1, 3)).toEqual(modules)
  })
})

describe('a pseudonym', () => {
  it('says group and number, and is read with small letters, blanks and points', () => {
    expect(pseudonymOf(2, 7)).toBe('0207' + 'TRWAGMYFPDXBNJZSQVHLCKE'[207 % 23])
    expect(readPseudonym(' 02.07 ' + pseudonymOf(2, 7).at(-1)!.toLowerCase())).toEqual({ group: 2, child: 7 })
  })

  it('with one wrong digit or two exchanged ones is none', () => {
    const of99 = fc.integer({ min: 1, max: 99 })
    fc.assert(
      fc.property(of99, of99, fc.nat(3), fc.nat(9), (group, child, at, digit) => {
        const right = pseudonymOf(group, child)
        expect(readPseudonym(right)).toEqual({ group, child })
        const wrong = right.slice(0, at) + String(digit) + right.slice(at + 1)
        if (wrong !== right) expect(readPseudonym(wrong)).toBeNull()
        const swapped = right.slice(0, at) + right[at + 1]! + right[at]! + right.slice(at + 2)
        if (swapped !== right) expect(readPseudonym(swapped)).toBeNull()
      }),
      { seed: 22, numRuns: 2000 },
    )
  })
})

describe('the file of a study', () => {
  it('comes back as it was written', () => {
    expect(readPlan(writePlan(plan))).toEqual(plan)
  })

  it.each([
    ['seed', { seed: 1.5 }],
    ['modules', { modules: [] }],
    ['modules', { modules: [plan.modules[0], plan.modules[0]] }],
    ['order', { order: 'reversed' }],
    ['groups', { groups: 100 }],
    ['word', { word: 'a b' }],
    ['child', { child: 'Lena' }],
  ])('with a wrong %s is refused by its name', (field, change) => {
    const act = () => readPlan({ ...plan, ...change })
    expect(act).toThrow(expect.objectContaining({ field }))
  })

  it('is read or refused, whatever stands in it', () => {
    const text = writePlan(plan)
    fc.assert(
      fc.property(fc.nat(text.length), fc.nat(20), fc.string({ maxLength: 6 }), (at, gone, put) => {
        try {
          readPlan(text.slice(0, at) + put + text.slice(at + gone))
        } catch (error) {
          expect(error).toBeInstanceOf(PlanError)
        }
      }),
      { seed: 22, numRuns: 2000 },
    )
  })
})
