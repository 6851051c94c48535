// Rooms: materials
// By address: codes on paper and links of a plan lead to a page of its own.
import { leftEye, leftWheel } from '../child.ts'
import { opensSettings, option } from '../child-cards.ts'
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'
import { readPdf } from '../pdf.ts'
import { givesVoice, heardOn, said } from '../voice.ts'
import { cardMessage, languagesOf } from '../words.ts'

/** A voice says a title first. */
const starting = (title: string) => new RegExp(`^${title.replaceAll(/[.*+?^${}()|[\]\\]/g, '\\$&')}`)

const ready = '.material[aria-busy="false"]'

for (const language of languagesOf(import.meta.filename))
  test.describe(`learning materials on the screen, in ${language}`, () => {
    test.use({ language })

    test('hints come one by one, and the lab and the page know of the same ones', async ({ child, page }) => {
      await page.goto('/materials/card/friendship')
      await expect(page.locator(ready)).toBeVisible()
      const hints = page.locator('.hints > li')
      await expect(hints).toHaveCount(3)
      const seen = () => hints.evaluateAll((all) => all.filter((one) => one.checkVisibility()).length)
      await expect.poll(seen).toBe(0)
      await child.presses('materials.askHint', { number: 1, of: 3 })
      await child.presses('materials.askHint', { number: 2, of: 3 })
      await expect.poll(seen).toBe(2)
      await child.opensLab('friendship')
      // The last one waits until something was tried.
      await child.typesWeight(leftEye, leftWheel, 0.3)
      await child.pressesStart()
      await child.seesDriving()
      await child.presses('lab.hint')
      await expect(page.getByText(child.word('lab.hintTitle', { number: 2, of: 3 }))).toBeVisible()
      await child.presses('lab.hintNext')
      await child.seesSaved()
      await page.goto('/materials/card/friendship')
      await expect(page.getByRole('status').getByText(child.word('materials.allHints'))).toBeVisible()
      await expect.poll(seen).toBe(3)
    })

    test('from its dialog in the lab a card goes to paper, on a page of A5 of its own', async ({
      child,
      page,
    }) => {
      await child.opensLab('fear')
      await child.presses('lab.card')
      const card = child.card('fear')
      await page
        .getByRole('dialog', { name: card })
        .getByRole('link', { name: child.word('lab.onPaper'), exact: true })
        .click()
      const paper = page.locator('html[data-print=ready] .paper')
      await expect(paper.getByRole('heading', { name: card }).first()).toBeVisible()
      await expect(page).toHaveURL(/\/materials\/card\/fear\?paper=a5$/)
      const { pages } = await readPdf(await page.pdf({ preferCSSPageSize: true, printBackground: true }))
      expect(pages.map(({ width, height }) => `${width} × ${height}`)).toEqual(['148 × 210', '148 × 210'])
    })

    test('settings are at hand: clear letters, a voice, slides without Bo', async ({ child, page }) => {
      await givesVoice(page, ['fr-FR', 'de-DE', 'en-GB'])
      await page.goto('/materials/worksheet/how-do-i-learn')
      await expect(page.locator(ready)).toBeVisible()
      await opensSettings(child, 'home')
      for (const name of ['quiet', 'letters', 'aloud'] as const) {
        await option(child, name).focus()
        await child.types('Space')
      }
      await child.types('Escape')
      const reads = async (what: string, facts = {}) => {
        const before = (await said(page)).length
        await child.presses('comfort.read', { what: child.word(`materials.${what}`, facts) })
        await expect.poll(() => said(page)).toHaveLength(before + 1)
        return (await said(page)).at(-1)!
      }
      await expect.poll(() => reads('thePage')).toMatch(starting(await page.locator('h1').innerText()))
      const font = await page.locator('h1').evaluate((title) => getComputedStyle(title).fontFamily)
      expect(font).toContain('Atkinson')
      await page.goto('/materials/slides/can-robots-learn-alone')
      await expect(page.locator(ready)).toBeVisible()
      await expect(page.locator('.slide .bo')).toHaveCount(0)

      await page.goto('/materials/slides/how-does-your-robot-learn?slide=2')
      const title = page.getByRole('heading', { level: 2 })
      await expect.poll(() => title.evaluate((one) => getComputedStyle(one).fontFamily)).toContain('Atkinson')
      await expect.poll(() => reads('theSlide', { number: 2 })).toMatch(starting(await title.innerText()))
      await page.goto('/materials/questions/1')
      const asked = await title.innerText()
      const choices = await page.locator('.answers > button').allInnerTexts()
      const question = await reads('theQuestion')
      expect(question).toMatch(starting(asked))
      expect(choices.map((choice) => question.indexOf(choice.trim()) > 0)).toEqual(choices.map(() => true))
      await page.locator('.answers button').first().click()
      await expect.poll(() => reads('theWhy')).toContain(child.word('materials.thatHappens'))
      await expect
        .poll(async () => new Set((await heardOn(page)).languages))
        .toEqual(new Set([{ de: 'de-DE', en: 'en-GB' }[language]]))
    })

    test('beside the library an item shows what it is, and leads to paper and to its questions', async ({
      child,
      page,
    }) => {
      await opensFromHome(child, 'home.materials')
      const name = child.card('city')
      await page.getByRole('searchbox').fill('Q3')
      await child.presses('materials.look', { title: name })
      const aside = page.getByRole('complementary')
      await expect(aside.getByRole('heading', { name })).toBeVisible()
      await expect(aside.locator(ready)).toBeVisible()
      await aside.getByRole('link', { name: child.word('materials.onPaper'), exact: true }).click()
      await expect(page.locator('.paper[aria-busy="false"]')).toBeVisible()
      await page.goBack()
      await aside
        .getByRole('link', { name: child.word('materials.module', { number: 1 }), exact: true })
        .click()
      await expect(page.getByRole('heading', { level: 1 })).toHaveText(
        child.word('materials.questions', { number: 1 }),
      )
    })

    test('what a lesson needs is put together, counted and printed with its cover', async ({
      child,
      page,
    }) => {
      await opensFromHome(child, 'home.materials')
      await page.getByRole('searchbox').fill('NN 5')
      await child.presses('materials.set.put', { title: child.card('friendship') })
      await page.getByRole('searchbox').fill('3.1')
      const sheet = page.locator('.library li').first()
      await expect(sheet).toContainText('3.1')
      await sheet.getByRole('button').first().click()
      const mySet = page.getByRole('region', { name: child.word('materials.set.title') })
      // A card for each pair, two on a sheet, and a sheet for each pair.
      const sum = (sheets: number) =>
        expect(mySet.getByRole('status')).toContainText(child.word('materials.set.sheets', { sheets }))
      await sum(6 + 12)
      await child.presses('materials.set.fewer')
      await child.presses('materials.set.fewer')
      await sum(6 + 11)
      await mySet.getByRole('spinbutton').first().fill('2')
      await mySet.getByRole('spinbutton').first().blur()
      await sum(1 + 11)
      await page.reload()
      await sum(1 + 11)
      // Two sets, each in both languages.
      await child.presses('materials.set.moreSets')
      await mySet.getByRole('button', { name: 'Deutsch + English' }).click()
      await sum(2 * 2 * (1 + 11))
      await mySet.getByRole('link', { name: child.word('materials.print'), exact: true }).click()
      await expect(page.locator('html[data-print=ready] .pack-cover')).toBeVisible()
      const { pages } = await readPdf(await page.pdf({ preferCSSPageSize: true, printBackground: true }))
      expect(pages.map(({ width, height }) => `${width} × ${height}`)).toEqual(Array(7).fill('210 × 297'))
      const [cover, german, , english] = pages.map(({ text }) => text)
      expect(cover).toContain(child.card('friendship'))
      expect([german, english]).toEqual([
        expect.stringContaining(cardMessage('de', 'friendship')),
        expect.stringContaining(cardMessage('en', 'friendship')),
      ])
      // The page speaks its own language again, and remembers no other.
      await page.reload()
      await expect(page.locator('html')).toHaveAttribute('lang', language)
    })
  })

test('many cards are fitted to paper once, and the page answers', async ({ page }) => {
  await page.addInitScript(() => {
    const told: unknown[] = []
    Object.assign(window, { told })
    new MutationObserver((all) => told.push(...all)).observe(document, {
      attributeFilter: ['data-print'],
      subtree: true,
    })
  })
  await page.goto('/materials/card/network-cards?paper=a4')
  await expect(page.locator('html[data-print=ready] .paper[aria-busy="false"]')).toBeVisible()
  await expect.poll(() => page.evaluate(() => (window as unknown as { told: unknown[] }).told.length)).toBe(1)
})

test('on a phone the numbers of the things on a slide stand next to them', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 })
  await page.goto('/materials/slides/can-robots-learn-alone?slide=2')
  const things = page.locator('.screen .things li')
  await expect(things).toHaveCount(12)
  const covered = () =>
    things.evaluateAll((all) =>
      all.flatMap((one) => {
        const [picture, number] = ['img', 'small'].map((part) => one.querySelector(part)!)
        const [a, b] = [picture!.getBoundingClientRect(), number!.getBoundingClientRect()]
        return a.right > b.left && a.bottom > b.top ? [number!.textContent] : []
      }),
    )
  await expect.poll(covered).toEqual([])
})

test('a deck printed by hand is its slides; with its notes it is sheets of A4', async ({ child, page }) => {
  // A window for printing would stop the page.
  await page.addInitScript(() => Object.assign(window, { print: () => undefined }))
  await page.goto('/materials/slides/can-robots-learn-alone')
  await expect(page.locator(ready)).toBeVisible()
  const slides = await readPdf(await page.pdf({ preferCSSPageSize: true, printBackground: true }))
  expect(slides.pages.map(({ width, height }) => `${width} × ${height}`)).toEqual(Array(15).fill('339 × 191'))
  expect(slides.pages[3]!.text).not.toContain(child.word('materials.notes'))
  await child.presses('materials.printNotes')
  const notes = await readPdf(await page.pdf({ preferCSSPageSize: true, printBackground: true }))
  expect(new Set(notes.pages.map(({ width, height }) => `${width} × ${height}`))).toEqual(
    new Set(['210 × 297']),
  )
  expect(notes.pages.map(({ text }) => text).join(' ')).toContain(child.word('materials.notes'))
})

test('the presenter says where there is nothing to say', async ({ child, page }) => {
  await page.goto('/materials/slides/can-robots-learn-alone?presenter')
  await expect(page.getByText(child.word('materials.noNotes'))).toBeVisible()
  await child.types('ArrowRight')
  await expect(page.getByText(child.word('materials.noNotes'))).toHaveCount(0)
})

test('on a slide things are sorted in their place', async ({ child, page }) => {
  await page.goto('/materials/slides/can-robots-learn-alone?slide=10')
  const sorting = page.frameLocator('iframe')
  await expect(sorting.getByRole('button', { name: child.word('sorting.play'), exact: true })).toBeVisible()
})

test('where the device has no voice for the language, nothing on the materials offers one', async ({
  child,
  page,
}) => {
  await givesVoice(page, ['fr-FR'])
  await page.addInitScript(() => localStorage.setItem('botgarten.comfort', '{"aloud":true}'))
  await page.goto('/materials/slides/can-robots-learn-alone?slide=2')
  await expect.poll(async () => (await heardOn(page)).asked).toBeGreaterThan(0)
  await expect(
    child.button('comfort.read', { what: child.word('materials.theSlide', { number: 2 }) }),
  ).toHaveCount(0)
})

test('where the device keeps nothing, a slide shows the card with its start program, and says so', async ({
  child,
  page,
}) => {
  await page.addInitScript(() =>
    Object.defineProperty(IDBFactory.prototype, 'open', {
      value: () => {
        throw new DOMException('Nothing is kept here.', 'SecurityError')
      },
    }),
  )
  await page.goto('/materials/slides/how-does-your-robot-learn?slide=7')
  await expect(page.getByText(child.word('materials.startInstead'))).toBeVisible()
  const lab = page.frameLocator('iframe')
  await lab
    .getByRole('button', { name: child.word('lab.start'), exact: true })
    .first()
    .click()
  await expect(lab.getByRole('button', { name: child.word('lab.stop'), exact: true }).first()).toBeVisible()
  await lab.getByRole('button', { name: child.word('lab.networkTab'), exact: true }).click()
  const weights = lab.getByRole('slider', {
    name: new RegExp(child.word('network.weight', { from: '.+', to: '.+' })),
  })
  await expect(weights.first()).toBeVisible()
  await expect
    .poll(async () => new Set(await weights.evaluateAll((all) => all.map((one) => one.ariaValueNow))))
    .toEqual(new Set(['0']))
})

test('the slide about the table of trials has its first run filled in, and every column is whole', async ({
  child,
  page,
}) => {
  await page.goto('/materials/slides/learn-from-experience')
  const row = page.locator('.slide .trials tbody tr').first()
  for (const cell of ['10', '58 s', '3-5-0-1'])
    await expect(row.getByRole('cell', { name: cell, exact: true })).toBeVisible()
  const column = page
    .locator('.slide .trials')
    .getByRole('columnheader', { name: child.word('q.column.way') })
  const aside = () =>
    column.evaluate(
      (one) => one.closest('.face')!.getBoundingClientRect().right - one.getBoundingClientRect().right,
    )
  await expect.poll(aside).toBeGreaterThan(0)
  const hidden = () =>
    page.locator('.slide .wide').evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)
  await expect.poll(hidden).toBe(0)
})
