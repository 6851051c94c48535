import type { Page } from '@playwright/test'
import { StudyHands, studyFile } from '../../child-study.ts'
import { expect, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

/** A print dialog would block the page: calls are counted instead. */
const printing = (page: Page) =>
  page.evaluate(() =>
    Object.assign(window, {
      prints: 0,
      print: () => ((globalThis as unknown as { prints: number }).prints += 1),
    }),
  )
const prints = (page: Page) => page.evaluate(() => (globalThis as unknown as { prints: number }).prints)

test('study mode, step by step', { tag: '@study' }, async ({ child, page }) => {
  const hands = new StudyHands(child)
  const field = (key: string) => page.getByLabel(child.word(key), { exact: true })
  const tick = (key: string) => page.getByRole('checkbox', { name: child.word(key), exact: true })
  const chooses = (key: string) =>
    page
      .getByRole('dialog')
      .getByRole('button', { name: child.word(key), exact: true })
      .click()
  const saves = async (key: string, facts = {}) => {
    const [file] = await Promise.all([page.waitForEvent('download'), child.presses(key, facts)])
    expect(file.suggestedFilename()).toMatch(/\.jsonl?$/)
  }
  const names = page.getByRole('textbox', { name: child.word('study.moduleName') })
  /** The study in the storage of the page. */
  const kept = () => page.evaluate((key) => localStorage.getItem(key), 'botgarten.study')
  let before: string | null = null
  await goesThrough(child, 'study', {
    'study mode': () => hands.comes(),
    'a file is refused': () => hands.opens('{}'),
    async 'a study is made'() {
      await child.presses('study.make')
      // Drawn by chance at first.
      await field('study.seed').fill('5')
    },
    async 'it has its title, word and numbers'() {
      await field('study.titleOf').fill('Spring')
      await field('study.wordOf').fill('Kiesel7')
      await field('study.groups').fill('2')
      await field('study.children').fill('3')
      await page.getByRole('combobox').selectOption({ index: 1 })
      await page.getByRole('radio').nth(1).check()
    },
    'a module is added': () => child.presses('study.addModule'),
    async 'modules have names and cards'() {
      await names.nth(0).fill('Neurons')
      await names.nth(1).fill('Trying')
      for (const at of [0, 1]) await page.locator('summary').nth(at).click()
      await tick('study.freeLab').first().check()
      await page
        .getByRole('checkbox', { name: child.card('fear'), exact: true })
        .nth(1)
        .check()
    },
    'a module is taken out': () => child.presses('study.removeModule', { number: 2 }),
    'there are as many modules as there may be': () =>
      child.button('study.addModule').evaluate((button: HTMLElement) => {
        for (let left = 11; left > 0; left -= 1) button.click()
      }),
    async 'a map is closed, and no log is written'() {
      for (let left = 11; left > 0; left -= 1) await child.presses('study.removeModule', { number: 2 })
      await page
        .getByRole('group', { name: child.word('study.mapsOf') })
        .getByRole('checkbox')
        .first()
        .uncheck()
      await tick('study.hasLog').uncheck()
      await saves('study.saveFile')
    },
    async 'slips of what is made'() {
      await child.presses('study.slips')
      await printing(page)
      await child.presses('study.print')
      await expect.poll(() => prints(page)).toBe(1)
    },
    async 'back to what is made'() {
      await child.presses('study.back')
      await field('study.seed').fill('5')
    },
    'study mode again': () => child.presses('study.back'),
    async 'a study is opened'() {
      const [chooser] = await Promise.all([page.waitForEvent('filechooser'), child.presses('study.openFile')])
      await chooser.setFiles({
        name: 'study.json',
        mimeType: 'application/json',
        buffer: Buffer.from(studyFile()),
      })
    },
    'its slips': () => child.presses('study.slips'),
    'back to the study': () => child.presses('study.back'),
    'orders of its groups': () => page.locator('summary').click(),
    'the end of the study is asked about': () => child.presses('study.endStudy'),
    'it is kept': () => chooses('study.keep'),
    'the consents are there': () => tick('study.consentBox').check(),
    async 'the device is handed out'() {
      await child.presses('study.handOut')
      await expect(child.words('study.hello')).toBeVisible()
      before = await kept()
    },
    async 'a wrong number'() {
      await hands.saysNumber(9, 9)
      await child.presses('study.yes')
    },
    'another number is written': () => hands.saysNumber(1, 1),
    'a word is asked for': () => child.presses('study.researcher'),
    async 'the word is wrong'() {
      await field('study.word').fill('wrong')
      await child.presses('study.enter')
    },
    'another word is written': () => field('study.word').fill('kies'),
    'a child begins': () => hands.begins(1, 1),
    'the log rests': () => child.presses('study.rest'),
    'the log goes on': () => child.presses('study.wake'),
    'the next part is asked about': () => child.presses('study.next'),
    'not yet': () => chooses('study.goBack'),
    async 'the next part'() {
      await child.presses('study.next')
      await chooses('study.sure')
    },
    'the end is asked about': () => child.presses('study.end'),
    'it is closed by its key': () => child.types('Escape'),
    async 'the child has ended'() {
      await child.presses('study.end')
      await chooses('study.sure')
    },
    'a child without a log': () => hands.begins(1, 2, 'no'),
    'another page has ended it': () =>
      page.evaluate(
        ([key, value]) => {
          localStorage.setItem(key, value)
          dispatchEvent(new StorageEvent('storage', { key }))
        },
        ['botgarten.study', before!] as const,
      ),
    async 'logs are there'() {
      await hands.begins(1, 3)
      await child.presses('study.end')
      await chooses('study.sure')
      await hands.saysWord()
    },
    async 'one is to be deleted'() {
      await saves('study.saveAll')
      await saves('study.saveOne', { pseudonym: '0101D' })
      await child.presses('study.deleteOne', { pseudonym: '0101D' })
    },
    'it is kept after all': () => chooses('study.keep'),
    async 'it is deleted'() {
      await child.presses('study.deleteOne', { pseudonym: '0101D' })
      await chooses('study.delete')
    },
    'all are to be deleted': () => child.presses('study.deleteAll'),
    'they are kept': () => child.types('Escape'),
    async 'they are deleted'() {
      await child.presses('study.deleteAll')
      await chooses('study.delete')
    },
    'the end is closed by its key': async () => {
      await child.presses('study.endStudy')
      await expect(page.getByRole('dialog')).toBeVisible()
      await child.types('Escape')
      await tick('study.consentBox').check()
    },
    async 'the study has ended'() {
      await child.presses('study.endStudy')
      await chooses('study.endStudy')
    },
    'a study without a log': () => hands.opens(studyFile({ log: false })),
    'it asks for a number alone': () => child.presses('study.handOut'),
    async 'a child goes'() {
      await hands.saysNumber(1, 1)
      await child.presses('study.go')
    },
  })
})
