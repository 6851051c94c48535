import { beforeAll, describe, expect, test } from 'vitest'
import { allItems, fetchItems, itemNamed, targetItem } from '../library.ts'
import { packNamed, readyPacks } from './packs.ts'

beforeAll(() => fetchItems())

const isAnswers = (of: string) => targetItem(of)?.kind === 'solution'
const lessons = allItems.flatMap(({ id, plan }) => (plan ? [{ id, lesson: plan.lesson }] : []))
const doubles = readyPacks().filter((id) => id.startsWith('double-'))

describe('the pack of a lesson', () => {
  test.each(lessons)('$id has the answers to its sheets once, if there are any', ({ id, lesson }) => {
    const answers = allItems.filter(({ kind, code }) => kind === 'solution' && code === `A ${lesson}`)
    const lines = packNamed(id)!.lines.map(({ of }) => of)
    for (const one of answers) expect(lines.filter((of) => of === `item:${one.id}`)).toHaveLength(1)
    expect(answers.length).toBeLessThanOrEqual(1)
  })

  test('some plans copy the answers themselves, and some do not', () => {
    const copied = lessons.flatMap(({ id, lesson }) => {
      const answers = allItems.find(({ kind, code }) => kind === 'solution' && code === `A ${lesson}`)
      const { copies } = itemNamed(id)!.plan!
      return answers ? [copies.some(({ of }) => of === `item:${answers.id}`)] : []
    })
    expect(new Set(copied)).toEqual(new Set([true, false]))
  })
})

describe('the pack of a double lesson', () => {
  test.each(doubles)('%s has each line once, and the answers last', (id) => {
    const lines = packNamed(id)!.lines.map(({ of }) => of)
    expect(new Set(lines).size).toBe(lines.length)
    const kinds = lines.map(isAnswers)
    expect(kinds.slice(kinds.indexOf(true)).every(Boolean)).toBe(true)
  })

  test.each(doubles)('%s begins with what its first lesson begins with', (id) => {
    const name = id.replace('double-', '').toUpperCase()
    const first = allItems.find(({ plan }) => plan?.double?.name === name)!
    expect(packNamed(id)!.lines[0]).toEqual(packNamed(first.id)!.lines[0])
  })
})
