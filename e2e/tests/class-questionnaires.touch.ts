// Rooms: class, questionnaires
import { opensForm } from '../asked-class.ts'
import { axeFindings } from '../axe.ts'
import { Asker, nth } from '../child-questionnaires.ts'
import { classOfTest } from '../class-server.ts'
import { expect, test as base } from '../house.ts'
import { joins, signsIn, type MadeClass } from '../made-class.ts'
import { givesVoice, said } from '../voice.ts'

const test = base.extend<object, { school: MadeClass }>({
  school: [
    // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
    async ({}, use) => {
      const school = await classOfTest('de')
      await use(school)
      await school.close()
    },
    { scope: 'worker' },
  ],
  house: [({ school }, use) => use(school.url), { scope: 'worker' }],
})

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
  expect(await axeFindings(page)).toEqual([])
  await asker.presses('form.bird.owl')
  await asker.presses('form.roll')
  await asker.begins()
  await expect(child.words('form.questionOf', { number: 1, of: 13 })).toBeVisible()
  await asker.presses('form.readAloud')
  expect((await said(page)).at(-1)).toContain(
    'sehr uninteressant. uninteressant. geht so. interessant. sehr interessant.',
  )
  await asker.fillsIn('after', true, nth(3))
  await asker.presses('form.readAloud')
  expect((await said(page)).at(-1)).toContain(child.word('form.thanks'))
  const sending = page.waitForResponse((response) => response.url().endsWith('/api/class/answers'))
  await page.clock.fastForward(120_000)
  expect((await sending).status()).toBe(204)
})
