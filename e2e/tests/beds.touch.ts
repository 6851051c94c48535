// Rooms: home, content, editor
import { isLong, tasks, walks, walksToVessels } from '../beds.ts'
import { test } from '../house.ts'
import { byFinger } from '../ways.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`by finger alone, in ${language}`, () => {
    test.use({ language })

    for (const task of tasks)
      test(`${task.card} is solved from home to the end`, async ({ child }) => {
        await walks(child, byFinger(child), task)
      })

    if (isLong)
      test('vessels are sorted', async ({ child }) => {
        await walksToVessels(child, byFinger(child))
      })
  })
