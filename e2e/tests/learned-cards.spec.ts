// Rooms: training, content
import { practises } from '../child-practising.ts'
import { tasks } from '../child-solving.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

/**
 * What a child does there: it shows places and words by hand, drives, finds wrong rows, takes mirror images too, helps
 * where the network goes wrong, stops in time, puts a hidden layer in, makes steps smaller.
 */
const learned = [
  'show-it',
  'dodge',
  'four-wrong',
  'only-left',
  'help-bo',
  'say-it',
  'by-heart',
  'either-or-2',
  'too-fast',
  'who-knows',
]

for (const language of languagesOf(import.meta.filename))
  test.describe(`cards that are learned from examples, in ${language}`, () => {
    test.use({ language })

    for (const task of tasks.filter(({ card }) => learned.includes(card.id)))
      test(`${task.card.id} is practised as its hints say, and Bo passes from its first place`, async ({
        child,
      }) => {
        await child.opensLab(task.card.id)
        await practises(child, task)
        await child.pressesStart()
        await new TimeHands(child).hurries()
        await expect(child.words('lab.successTitle').first()).toBeVisible({ timeout: 40_000 })
        for (const { id } of task.card.checks) await child.seesCheck(task.card.id, id)
      })
  })
