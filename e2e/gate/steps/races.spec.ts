import { follows, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

test('races of learners, step by step', { tag: '@races' }, async ({ child, page }) => {
  const radio = (key: string) => page.getByRole('radio', { name: child.word(key) })
  await goesThrough(child, 'races', {
    'the races': () => follows(child, 'home.race'),
    'a criterion is chosen': () => radio('race.criterion.falls').check(),
    'four learners race': () => child.presses('race.start'),
  })
})
