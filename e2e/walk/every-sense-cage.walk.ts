import { content } from '@botgarten/content/files'
import { SenseVisitor } from '../child-sense-zoo.ts'
import { test } from '../house.ts'
import { isSampled } from '../sample.ts'
import { languages } from '../words.ts'

for (const language of languages.filter((one) => isSampled(`every-sense-cage ${one}`)))
  test.describe(`the loophole zoo in ${language}`, () => {
    test.use({ language })

    test('is walked from cage to cage, each predicted, watched, mended and tried until a Bo drives', async ({
      child,
    }) => {
      const zoo = new SenseVisitor(child)
      await zoo.comes()
      for (const cage of content.senseCages)
        await test.step(cage.cage.id, async () => {
          await zoo.enters(cage)
          await zoo.guesses(cage)
          await zoo.watches(cage)
          // There is one whose mend is a riddle, too.
          if (cage.rows.bos.some(({ mended }) => mended !== null)) {
            await zoo.mends(cage)
            await zoo.triesUntilMended()
          }
          await zoo.leaves()
        })
    })
  })
