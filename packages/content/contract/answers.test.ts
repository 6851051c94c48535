import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, test } from 'vitest'
import { answersOf } from '../answers/index.ts'
import { content } from '../files.ts'
import { codeOfAll } from '../items/pack.ts'
import { embedsOf } from '../items/walk.ts'
import type { Item } from '../schema/itemTypes.ts'
import { expectTrue, named } from './claims.ts'

addBlocks(learning)

test('every number of the answers is what the learner comes to: `npm run answers` writes them', () => {
  expect(content.answers()).toEqual(answersOf(content))
})

/** Ids of the sheets of a lesson on which somebody writes their name. */
const writtenOn = ({ plan }: Item): readonly Item[] =>
  plan!.copies.flatMap(({ of }) => {
    const item = content.items.find(({ id }) => of === `item:${id}`)
    const names = item && embedsOf(textOf(item, 'en')).some(({ kind }) => kind === 'name')
    return item?.kind === 'worksheet' && names ? [item] : []
  })
const textOf = ({ kind, id }: Item, language: string) => content.itemTexts(language).items[`${kind}/${id}`]!

const plans = content.items.filter(({ plan }) => plan)

describe.each(plans)('the lesson of $code', (lesson) => {
  const sheets = writtenOn(lesson)
  const answers = content.items.find(
    ({ kind, code }) => kind === 'solution' && code === `A ${lesson.plan!.lesson}`,
  )

  test('has answers to every sheet that is written on, in every language', () => {
    for (const language of sheets.length > 0 ? completeLanguages : []) {
      const titles = textOf(answers!, language).sections.map(({ title }) => title)
      const codes = sheets.map((sheet) => codeOfAll(sheet)!)
      expect(codes.filter((code) => titles.every((title) => !title.startsWith(code)))).toEqual([])
    }
  })
})

const claimed = content.items.flatMap(({ id, claims = [] }) => (claims.length > 0 ? [{ id, claims }] : []))

describe.each(claimed)('what $id says of runs', ({ claims }) => {
  test.each(claims.map(named))('%s', (_, claim) => expectTrue(claim))
})
