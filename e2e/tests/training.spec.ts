// Rooms: training
import { sixRows, Teaching, weightsOfSixRows } from '../child-training.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

test('a child shows Bo what to do, lets it practise and drive, repairs a row, and takes its table along', async ({
  child,
  page,
}) => {
  const teaching = new Teaching(child)
  await child.opensLab('friendship')
  await teaching.shows()
  await teaching.remembers(45, 45)
  await teaching.remembers(25, 60)
  await teaching.seesExamples(2)
  await page.keyboard.press('Control+z')
  await teaching.seesExamples(1)

  await teaching.chooses('drive')
  await teaching.drivesUntil(() => expect.poll(() => teaching.count()).toBeGreaterThan(4))
  await expect(child.button('lab.continue').first()).toBeVisible()
  const driven = await teaching.count()
  await child.pressesStop()

  await teaching.opensFile('rows.csv', sixRows)
  await teaching.seesExamples(driven + 6)
  await child.presses('training.onlyThese')
  await teaching.seesExamples(6)
  await teaching.setsAside(2)
  await teaching.seesExamples(5)
  await child.presses('training.aside', { count: 1 })
  await teaching.takesBack(2)
  await child.presses('training.toTable')
  await teaching.seesExamples(6)

  await teaching.letsPractise()
  await teaching.practises()
  await expect.poll(() => teaching.hashOfWeights()).toBe(weightsOfSixRows)
  await expect(teaching.curve).toHaveAttribute('aria-valuenow', '60')
  await teaching.curve.press('Home')
  await expect(teaching.curve).toHaveAttribute('aria-valuenow', '0')
  await teaching.curve.press('End')
  await expect(teaching.curve).toHaveAttribute('aria-valuenow', '60')
  await expect.poll(() => teaching.hashOfWeights()).toBe(weightsOfSixRows)

  await child.presses('training.fieldView')
  await expect(page.getByRole('img', { name: /^Field/ })).toBeVisible()
  await child.presses('training.alone')
  await child.presses('training.aloneGo')
  await expect(page.getByText(/^Round 60: [234] of 4$/)).toBeVisible()
  await child.presses('training.knobsView')

  await child.presses('training.oneExample')
  for (const beat of ['inputs', 'sums', 'says', 'error', 'arrows', 'knobs'])
    await child.presses(`training.next.${beat}`)
  await child.presses('training.close')
  await expect.poll(() => teaching.hashOfWeights()).not.toBe(weightsOfSixRows)
  await page.keyboard.press('Control+z')
  await expect.poll(() => teaching.hashOfWeights()).toBe(weightsOfSixRows)

  await child.pressesStart()
  await expect(page.getByText(child.word('training.drove'))).toBeVisible()
  await child.pressesStop()

  await teaching.shows()
  const csv = await teaching.saves('training.saveCsv')
  const json = await teaching.saves('training.saveJson')
  await teaching.opensFile('again.csv', csv)
  await teaching.seesExamples(12)
  await teaching.opensFile('again.json', json)
  await teaching.seesExamples(18)
  await teaching.opensFile('other.csv', 'a;b;c;d\n1,5;2;3;4\n')
  await child.presses('training.takeRows', { count: 1 })
  await teaching.seesExamples(19)
  await teaching.opensFile('broken.csv', 'eyeLeft,eyeRight,wheelLeft,wheelRight\n1,2,x,4\n')
  await expect(
    page.getByText(child.word('training.file.table.noNumber', { row: 2, column: 3, cell: 'x' })),
  ).toBeVisible()
})

for (const language of languagesOf(import.meta.filename))
  test.describe(`with nothing but keys and without motion, in ${language}`, () => {
    test.use({ language })

    test('a child remembers two rows, practises, goes back to a round and lets Bo drive', async ({
      child,
      page,
    }) => {
      await page.emulateMedia({ reducedMotion: 'reduce' })
      const teaching = new Teaching(child)
      await child.opensLab('show-it')
      const ways = page.getByRole('toolbar', { name: child.word('network.ways'), exact: true })
      await expect(teaching.table).toBeVisible()

      for (const [row, presses] of [
        [1, 8],
        [2, 4],
      ] as const) {
        for (const wheel of ['training.leftWheel', 'training.rightWheel'])
          await child.tabsTo(page.getByRole('slider', { name: child.word(wheel), exact: true }))
        await child.types(...Array.from({ length: presses }, () => 'ArrowRight'))
        await child.tabsTo(page.locator('.hand .main').getByRole('button'))
        await child.types('Enter')
        await teaching.seesExamples(row)
      }
      await expect(teaching.table.getByRole('button', { name: / 60$/ })).toBeVisible()

      await child.tabsTo(ways.locator('[tabindex="0"]'))
      await child.types('ArrowRight', 'Enter')
      await child.tabsTo(page.locator('.practise .bar .button.network'))
      await child.types('Enter')
      await expect(child.words('training.done')).toBeVisible()
      await child.tabsTo(teaching.curve)
      await child.types('Home')
      await expect(teaching.curve).toHaveAttribute('aria-valuenow', '0')
      await child.types('End')
      await expect(teaching.curve).toHaveAttribute('aria-valuenow', '60')
      await child.pressesStart()
      await child.seesDriving()
    })
  })
