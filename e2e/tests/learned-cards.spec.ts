// Rooms: training, content
import { practises } from '../child-practising.ts'
import { tasks } from '../child-solving.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { sampled } from '../variant.ts'
import { languagesOf } from '../words.ts'

/** What a child does there: it finds wrong rows, takes mirror images too, helps where the network goes wrong, shows words, puts a hidden layer in. */
const hands = ['four-wrong', 'only-left', 'help-bo', 'say-it', 'either-or-2']
/** It shows places by hand, drives (training.spec.ts has both), stops in time, makes steps smaller. */
const others = ['show-it', 'dodge', 'by-heart', 'too-fast', 'who-knows']
const learned = sampled([...hands, ...others])

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
