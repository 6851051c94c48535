import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { expect, test } from 'vitest'
import { answersOf } from '../answers/index.ts'
import { content } from '../files.ts'

addBlocks(learning)

test('every number of the answers is what the learner comes to: `npm run answers` writes them', () => {
  expect(content.answers()).toEqual(answersOf(content))
})
