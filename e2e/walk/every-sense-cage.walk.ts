import { content } from '@botgarten/content/files'
import { SenseVisitor } from '../child-sense-zoo.ts'
import { test } from '../house.ts'
import { settingsOf, variantsOf } from '../variant.ts'

for (const variant of variantsOf('every-sense-cage'))
  test.describe(`the loophole zoo in ${variant.language}, by ${variant.hand}`, () => {
    test.use(settingsOf(variant))

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
