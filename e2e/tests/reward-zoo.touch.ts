// Rooms: reward-zoo, content
import { content } from '@botgarten/content/files'
import { ZooVisitor } from '../child-zoo.ts'
import { test } from '../house.ts'
import { languagesOf } from '../words.ts'

const cageOf = (id: string) => content.cages.find(({ cage }) => cage.id === id)!

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`by finger alone, in ${language}`, () => {
    test.use({ language })

    test('two cages are guessed, watched and mended', async ({ child }) => {
      const zoo = new ZooVisitor(child)
      await zoo.comes()
      for (const [index, cage] of [cageOf('fountain'), cageOf('hill')].entries()) {
        await zoo.enters(cage)
        await zoo.guesses(cage)
        await zoo.watches(cage, 'never')
        await zoo.steps()
        await ('rule' in cage.cage.mend ? zoo.pullsReward(cage) : zoo.mends(cage))
        await zoo.seesMended(cage)
        await zoo.watches(cage, 'wish')
        await zoo.leaves(index + 1)
      }
    })
  })
}
