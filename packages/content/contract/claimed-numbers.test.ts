import { expect, test } from 'vitest'
import { content } from '../files.ts'
import { textOf } from './there.ts'

/** What is worked out elsewhere: by value iteration over the zoo, or a sum on paper. */
const elsewhere = ['solutions-senses', 'lesson-questionnaire']

/** What a run or practice takes, or comes to. */
const measured = /(\d+(?:\.\d+)?) (?:s\b|seconds|percent|rounds|of 100)/g

const speaking = content.items.filter(
  ({ id, kind }) => (kind === 'solution' || kind === 'plan') && !elsewhere.includes(id),
)

test('seconds, percent and rounds of answers and plans stand in a claim, which a test makes true', () => {
  const open = speaking.flatMap(({ id, claims = [], plan }) => {
    const claimed = new Set(JSON.stringify([...claims, ...(plan?.claims ?? [])]).match(/\d+(?:\.\d+)?/g))
    const words = textOf(content.itemFolder(id), 'en.md').replaceAll(/^::.*$/gm, '')
    return [...words.matchAll(measured)].flatMap(([said, number]) =>
      claimed.has(number!) ? [] : [`${id}: ${said}`],
    )
  })
  expect(open).toEqual([])
})
