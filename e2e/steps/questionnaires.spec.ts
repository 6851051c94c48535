import { opensForm } from '../asked-class.ts'
import { Asker, nth } from '../child-questionnaires.ts'
import { joins, signsIn } from '../made-class.ts'
import { givesVoice } from '../voice.ts'
import { expect, link, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

const five = [0, 1, 2, 3, 4]

test('a form for grade 3, step by step', { tag: '@questionnaires' }, async ({ child, page }) => {
  await givesVoice(page, ['en-GB'])
  const asker = new Asker(child)
  const { items } = asker.form('after').form
  const skips = async (times: number) => {
    for (let left = times; left > 0; left -= 1) await child.presses('form.skip')
  }
  const number = page.getByLabel(child.word('form.number'), { exact: true })
  await goesThrough(child, 'questionnaires-young', {
    'all questionnaires': () => asker.comes(),
    async 'a form is asked'() {
      await asker.asks('after', 3)
    },
    async 'it is read aloud'() {
      // This voice speaks until it is stopped.
      await page.evaluate(() => {
        let spoken: { onend?: () => void } = {}
        const speak = (words: typeof spoken) => (spoken = words)
        Object.assign(speechSynthesis, { speak, cancel: () => spoken.onend?.() })
      })
      await child.presses('form.readAloud')
    },
    'reading stops': () => child.presses('form.hush'),
    async 'a code is chosen'() {
      await child.presses('form.roll')
      await expect(number).toHaveValue(/^[1-9]\d\d$/)
      await asker.choosesCode('owl', 200)
    },
    'the first question': () => asker.begins(),
    async 'a face is chosen'() {
      await asker.answers('after', items[0]!, '4', true)
    },
    'the next question': () => child.presses('form.next'),
    'the question before': () => child.presses('form.back'),
    'a question of three choices': () => skips(6),
    async 'a question to write about'() {
      await asker.answers('after', items[6]!, 'yes', true)
      await child.presses('form.next')
      await asker.answers('after', items[7]!, 'Bo', true)
    },
    async 'a question about Bo'() {
      await skips(3)
      await expect(page.locator('.bo figure')).toBeVisible()
    },
    async 'the last question'() {
      await skips(2)
      await expect(page.locator('.bo figure')).toBeVisible()
    },
    'the form is done': () => child.presses('form.done'),
    async 'the next child takes a code that is taken'() {
      await child.presses('form.nextChild')
      await asker.choosesCode('owl', 200)
    },
    async 'a child without a code'() {
      await child.presses('form.codeForgot')
    },
    async 'the questions are ended'() {
      await skips(12)
      await child.presses('form.done')
      await child.presses('form.close')
    },
  })
})

test('a form for grade 5, step by step', { tag: '@questionnaires' }, async ({ child, page }) => {
  await givesVoice(page, ['fr-FR'])
  const asker = new Asker(child)
  const { items } = asker.form('after').form
  const next = () => child.presses('form.next')
  const takes = async (form: string, grade: number, children: readonly number[]) => {
    await asker.takesFile(form, grade, children)
    await expect(child.words('form.takenAnswers', { count: children.length })).toHaveCount(1)
  }
  const print = () =>
    page.evaluate(() =>
      Object.assign(window, {
        prints: 0,
        print: () => ((globalThis as unknown as { prints: number }).prints += 1),
      }),
    )
  const prints = () => page.evaluate(() => (globalThis as unknown as { prints: number }).prints)
  const downloads = async (press: () => Promise<unknown>) => {
    const [file] = await Promise.all([page.waitForEvent('download'), press()])
    expect(file.suggestedFilename()).toMatch(/\.(json|zip)$/)
  }
  const button = (name: string) => page.getByRole('button', { name, exact: true })
  await goesThrough(
    child,
    'questionnaires-older',
    {
      async 'a form is asked'() {
        await asker.comes()
        await asker.asks('after', 5)
      },
      'no voice reads it': () => child.presses('form.readAloud'),
      'all questionnaires are there again': () => asker.comes(),
      'asking goes on': () => link(child, 'form.goOnAsking').click(),
      async 'the first topic'() {
        await asker.choosesCode('robin', 300)
        await asker.begins()
      },
      'a number is chosen': () => asker.answers('after', items[0]!, '2', false),
      'the next topic': next,
      'the topic before': () => child.presses('form.back'),
      async 'questions to write about'() {
        for (const _ of [1, 2, 3]) await next()
        await asker.answers('after', items[7]!, 'Bo 🌱', false)
      },
      async 'questions about Bo'() {
        await next()
        await next()
        await expect(page.locator('.bo figure')).toHaveCount(2)
        await expect(page.locator('.bo [aria-busy=true]')).toHaveCount(0)
      },
      'the form is done': () => child.presses('form.done'),
      async 'results are still open'() {
        await asker.comes()
        await takes('after', 5, five)
        // By address: no link leads to the results before the form is closed.
        await page.goto('/questionnaires?form=after&show=results')
      },
      'the results': () => child.presses('form.close'),
      async 'all questionnaires, with answers'() {
        await downloads(() => button('CSV').click())
        await print()
        await child.presses('form.print')
        await expect.poll(prints).toBe(1)
        await link(child, 'form.all').click()
      },
      async 'results of few'() {
        await takes('before', 5, [0, 1])
        await asker.opens('before', 'form.results')
      },
      async 'results of two groups, before and after'() {
        await link(child, 'form.all').click()
        await takes('before', 9, [5, 6, 7, 8, 9])
        await takes('before', 5, [2, 3, 4])
        await takes('after', 9, [5, 6, 7, 8, 9])
        await asker.opens('after', 'form.results')
      },
      'one group alone': () => page.locator('.groups button').nth(1).click(),
      'all groups': () => child.presses('form.allGrades'),
      // The order of sentences is random.
    },
    { hides: /(?<=Bo )🌱+/gu },
  )
})

test(
  'forms are printed, typed and changed, step by step',
  { tag: '@questionnaires' },
  async ({ child, page }) => {
    const asker = new Asker(child)
    const question = asker.form('after').text['en']!.words['go-on']!
    const group = page.getByRole('group', { name: question['question']! })
    const sheets = page.getByLabel(child.word('form.sheets'), { exact: true })
    const counts = (answer: string, count: string) =>
      group.getByLabel(question[answer]!, { exact: true }).fill(count)
    const presses = (key: string) =>
      page
        .getByRole('dialog')
        .getByRole('button', { name: child.word(key), exact: true })
        .click()
    const downloads = async (key: string) => {
      const [file] = await Promise.all([page.waitForEvent('download'), child.presses(key)])
      expect(file.suggestedFilename()).toMatch(/\.json$/)
      return file
    }
    const made = page.getByRole('article').filter({ hasText: 'Our day' })
    let form = ''
    await goesThrough(child, 'questionnaires-teacher', {
      async 'a form on paper'() {
        await asker.comes()
        await asker.opens('after', 'form.paper')
        await expect(page.locator('figure')).toHaveCount(2)
        await page.evaluate(() =>
          Object.assign(window, { print: () => document.body.setAttribute('data-asked', '') }),
        )
        await child.presses('form.print')
        await expect(page.locator('[data-asked]')).toBeAttached()
      },
      async 'the form for the youngest'() {
        await child.presses('form.forYoung')
      },
      'the form for older ones': () => child.presses('form.forOlder'),
      async 'counts are typed'() {
        await link(child, 'form.all').click()
        await asker.opens('after', 'form.typeIn')
      },
      async 'there are too many'() {
        await sheets.fill('7')
        await page.getByRole('combobox').selectOption('9')
        await counts('yes', '8')
        await page.getByRole('textbox').first().fill('Bo')
      },
      async 'they fit'() {
        await counts('yes', '5')
        await counts('maybe', '2')
      },
      'they are added': () => child.presses('form.addTyped'),
      async 'some are typed already'() {
        await link(child, 'form.all').click()
        await asker.opens('after', 'form.typeIn')
      },
      'they are taken out': () => child.presses('form.removeTyped'),
      async 'a form is copied'() {
        await link(child, 'form.all').click()
        await asker.opens('after', 'form.copy')
      },
      async 'it has other questions'() {
        await page.getByLabel(child.word('form.formTitle'), { exact: true }).fill('Our day')
        await page.getByRole('checkbox').nth(1).uncheck()
        await page
          .getByRole('textbox', { name: child.word('form.question') })
          .first()
          .fill('How was it?')
        await child.presses('form.addScale')
      },
      async 'all that it asks has words'() {
        await child.presses('form.addText')
        for (const at of [-1, -2])
          await page
            .getByRole('textbox', { name: child.word('form.question') })
            .nth(at)
            .fill(`Why ${at}?`)
      },
      'it has as many questions as there may be': () =>
        child.button('form.addText').evaluate((button: HTMLElement) => {
          for (let left = 60; left > 0; left -= 1) button.click()
        }),
      async 'it is begun again and saved'() {
        await link(child, 'form.all').click()
        await asker.opens('after', 'form.copy')
        await page.getByLabel(child.word('form.formTitle'), { exact: true }).fill('Our day')
        form = await (await downloads('form.formFile')).path()
        await child.presses('form.saveForm')
        await expect(made).toBeVisible()
      },
      'it is changed once more': () =>
        made.getByRole('link', { name: child.word('form.change'), exact: true }).click(),
      'it is removed': () => child.presses('form.removeForm'),
      async 'a form comes from a file'() {
        const [chooser] = await Promise.all([
          page.waitForEvent('filechooser'),
          child.presses('form.readFile'),
        ])
        await chooser.setFiles(form)
      },
      'a file is refused': () => child.opensFileAtHome('answers.json', '{}'),
      async 'answers come from a file'() {
        await asker.takesFile('before', 5, five)
        await expect(child.words('form.takenAnswers', { count: 5 })).toBeVisible()
      },
      async 'answers are to be deleted'() {
        await downloads('form.saveFile')
        await child.presses('form.delete')
      },
      'they are kept': () => presses('form.keep'),
      async 'they are kept by a key'() {
        await child.presses('form.delete')
        await expect(page.getByRole('dialog')).toBeVisible()
        await child.types('Escape')
        await page.getByRole('combobox').selectOption('9')
      },
      async 'they are deleted'() {
        await child.presses('form.delete')
        await presses('form.delete')
      },
    })
  },
)

test('a pupil answers a form, step by step', { tag: '@questionnaires' }, async ({ child, page, school }) => {
  const asker = new Asker(child)
  await opensForm(school, 'after')
  await signsIn(page, school, await joins(school, 'Kiwi'))
  await goesThrough(child, 'questionnaires-pupil', {
    async 'the class asks'() {
      await child.opensHome()
      await link(child, 'class.askedGo').click()
      await expect(child.words('form.codeTitle')).toBeVisible()
      await expect(page.locator('.beforehand figure')).toHaveCount(2)
    },
    'the first topic': () => child.presses('form.codeForgot'),
    'all is answered': () => asker.fillsIn('after', false, nth(1)),
    async 'it was answered already'() {
      // By address: a pupil loads the page again.
      await page.goto('/questionnaires/class')
    },
  })
})
