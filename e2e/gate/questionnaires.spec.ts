import { opensForm } from '../asked-class.ts'
import { Asker, nth } from '../child-questionnaires.ts'
import { joins, signsIn } from '../made-class.ts'
import { expect, follows, link, test } from './gate.ts'

test.use({ language: 'de' })

test(
  'a form is answered on a device and by four in a file; results come when it is closed',
  {
    tag: ['@questionnaires', '@/questionnaires'],
  },
  async ({ child, page }) => {
    const asker = new Asker(child)
    await follows(child, 'home.materials')
    await page.getByRole('link', { name: child.word('materials.questionnaires') }).click()
    await expect(page).toHaveURL(/\/questionnaires$/)
    await expect(child.words('form.lead')).toBeVisible()
    await asker.asks('after', 5)
    await asker.choosesCode('owl', 200)
    await asker.begins()
    await asker.fillsIn('after', false, nth(0))
    await page.goto('/questionnaires')
    await asker.takesFile('after', 5, [1, 2, 3, 4])
    await expect(child.words('form.takenAnswers', { count: 4 })).toBeVisible()
    await child.presses('form.close')
    await asker.opens('after', 'form.results')
    const { words } = asker.form('after').text['de']!
    const row = page.getByRole('row').filter({ hasText: words['supervised']!['label']! }).first()
    // The n-th child says n % 5 + 1: the mean of 1 to 5.
    await expect(row).toContainText('3,00')
  },
)

test(
  'a pupil answers what the class is asked, and only the answers come to the class',
  {
    tag: ['@questionnaires', '@/questionnaires/class', '@class'],
  },
  async ({ child, page, school }) => {
    await opensForm(school, 'after')
    await page.clock.install()
    await signsIn(page, school, await joins(school, 'Kiwi'))
    await child.opensHome()
    await link(child, 'class.askedGo').click()
    const asker = new Asker(child)
    await expect(child.words('form.codeTitle')).toBeVisible()
    await child.presses('form.codeForgot')
    await asker.fillsIn('after', false, nth(1))
    const sending = page.waitForResponse((response) => response.url().endsWith('/api/class/answers'))
    await page.clock.fastForward(120_000)
    const response = await sending
    expect(response.status()).toBe(204)
    expect(JSON.stringify(response.request().postDataJSON())).not.toContain('Kiwi')
  },
)
