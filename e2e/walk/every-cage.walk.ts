import { content } from '@botgarten/content/files'
import { ZooVisitor } from '../child-zoo.ts'
import { test } from '../house.ts'
import { settingsOf, variantsOf } from '../variant.ts'

for (const variant of variantsOf('every-cage'))
  test.describe(`the zoo in ${variant.language}, by ${variant.hand}`, () => {
    test.use(settingsOf(variant))

    test('is walked from cage to cage, each guessed, watched, stepped, mended and watched again', async ({
      child,
    }) => {
      const zoo = new ZooVisitor(child)
      await zoo.comes()
      for (const [index, cage] of content.cages.entries())
        await test.step(cage.cage.id, async () => {
          await zoo.enters(cage)
          await zoo.guesses(cage)
          await zoo.watches(cage, cage.cage.claim.aLot)
          await zoo.steps()
          await zoo.mends(cage)
          await zoo.seesMended(cage)
          await zoo.watches(cage, 'wish')
          await zoo.leaves(index + 1)
        })
    })
  })
