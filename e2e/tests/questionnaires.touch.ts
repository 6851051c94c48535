// Rooms: questionnaires
import { Asker, nth } from '../child-questionnaires.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`questionnaires by finger in ${language}`, () => {
    test.use({ language })

    for (const grade of [3, 6])
      test(`a child of grade ${grade} answers on one device`, async ({ child, page }) => {
        const asker = new Asker(child, 'tap')
        await asker.comes()
        await asker.asks('after', grade)
        await asker.choosesCode('heron', 512)
        await asker.begins()
        await asker.fillsIn('after', grade < 5, nth(2))
        await asker.presses('form.close')
        await expect(page.getByText(child.word('form.few')).first()).toBeVisible()
      })
  })
