// Rooms: class, questionnaires
import { opensForm } from '../asked-class.ts'
import { Asker, nth } from '../child-questionnaires.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, signsIn } from '../made-class.ts'
import { givesVoice, said } from '../voice.ts'

const test = testInClass('de')
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

test.use({ language: 'de' })

test('a child of grade 3 answers by finger what is read aloud, and it comes to the class', async ({
  child,
  page,
  school,
}) => {
  await school.teacher.ask('PATCH', `/classes/${school.id}`, { grade: 3 })
  await opensForm(school, 'after')
  await givesVoice(page, ['de-DE'])
  await page.clock.install()
  await signsIn(page, school, await joins(school, 'Kiwi'))
  await page.goto('/')
  await expect(child.words('class.askedTitle')).toBeVisible()
  await page.getByRole('link', { name: child.word('class.askedGo'), exact: true }).tap()
  const asker = new Asker(child, 'tap')
  await expect(child.words('form.codeTitle')).toBeVisible()
  await asker.presses('form.bird.owl')
  await asker.presses('form.roll')
  await asker.begins()
  await expect(child.words('form.questionOf', { number: 1, of: 13 })).toBeVisible()
  await asker.presses('form.readAloud')
  await expect
    .poll(async () => (await said(page)).at(-1))
    .toContain('sehr uninteressant. uninteressant. geht so. interessant. sehr interessant.')
  await asker.fillsIn('after', true, nth(3))
  await asker.presses('form.readAloud')
  await expect.poll(async () => (await said(page)).at(-1)).toContain(child.word('form.thanks'))
  const sending = page.waitForResponse((response) => response.url().endsWith('/api/class/answers'))
  await page.clock.fastForward(120_000)
  expect((await sending).status()).toBe(204)
})
