// Rooms: home, content, editor
import { isLong, tasksByKeys, walks, walksToVessels } from '../beds.ts'
import { test } from '../house.ts'
import { byKeys } from '../ways.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`by keys alone, in ${language}`, () => {
    test.use({ language })

    for (const task of tasksByKeys)
      test(`${task.card} is solved from home to the end`, async ({ child }) => {
        await walks(child, byKeys(child), task)
      })

    if (isLong)
      test('vessels are sorted', async ({ child }) => {
        await walksToVessels(child, byKeys(child))
      })
  })
