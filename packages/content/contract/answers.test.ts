import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { describe, expect, test } from 'vitest'
import { answersOf } from '../answers/index.ts'
import { content } from '../files.ts'
import { expectTrue, named } from './claims.ts'

addBlocks(learning)

test('every number of the answers is what the learner comes to: `npm run answers` writes them', () => {
  expect(content.answers()).toEqual(answersOf(content))
})

const claimed = content.items.flatMap(({ id, claims = [] }) => (claims.length > 0 ? [{ id, claims }] : []))

describe.each(claimed)('what $id says of runs', ({ claims }) => {
  test.each(claims.map(named))('%s', (_, claim) => expectTrue(claim))
})
