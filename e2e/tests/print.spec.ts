// Rooms: materials, cli
import { spawnSync } from 'node:child_process'
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Learner } from '../child-learning.ts'
import { expect, test } from '../house.ts'
import { readPdf } from '../pdf.ts'
import { languagesOf } from '../words.ts'

const house = join(import.meta.dirname, '../..')
const folders: string[] = []
const fresh = () => {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-print-'))
  folders.push(folder)
  return folder
}
// A worker that is given the file's tests in turns calls this after each of them.
test.afterAll(() => {
  for (const folder of folders.splice(0)) rmSync(folder, { recursive: true })
})

/** Calls the command line as a teacher would. */
function botgarten(args: readonly string[], env: NodeJS.ProcessEnv = {}) {
  const { status, stdout, stderr } = spawnSync(
    process.execPath,
    [join(house, 'apps/cli/botgarten.ts'), 'print', ...args],
    { encoding: 'utf8', env: { ...process.env, LC_ALL: 'en_GB.UTF-8', ...env } },
  )
  return { status, stdout, stderr }
}

const titles = {
  de: { city: 'Stadt', program: 'Das Programm', drive: 'Karten zur ersten Fahrt' },
  en: { city: 'City', program: 'The program', drive: 'First Drive Cards' },
}
/** A long address goes on in the next line. */
const unbroken = (text: string) => text.replaceAll(' ', '')

/** Words that only the other language has. */
const foreign = {
  de: /\b(the|you|guess|trials|reward|print)\b/i,
  en: /\b(und|der|die|nicht|Läufe|Belohnung|drucken)\b/,
}

for (const language of languagesOf(import.meta.filename))
  test(`botgarten print: cards on A4 and A5 and a sheet, in ${language}`, async () => {
    const [two, one] = [fresh(), fresh()]
    const said = ['--lang', language, '--address', 'https://botgarten.example.org/school']
    const call = botgarten(['q-city', 'first-drive-cards', 'q-program', ...said, '--out', two])
    expect(call).toMatchObject({ status: 0, stderr: '' })
    expect(readdirSync(two).sort()).toEqual([
      `card-02-first-drive-cards-${language}-a4.pdf`,
      `card-06-q-city-${language}-a4.pdf`,
      `sheet-01-q-program-${language}.pdf`,
    ])
    const read = (folder: string, name: string) => readPdf(readFileSync(join(folder, name)))

    const sheet = await read(two, `sheet-01-q-program-${language}.pdf`)
    expect(sheet).toMatchObject({
      tagged: true,
      language: expect.stringMatching(new RegExp(`^${language}`)),
    })
    expect(sheet.title).toContain(titles[language].program)
    expect(sheet.outline.join()).toContain(titles[language].program)
    for (const { width, height } of sheet.pages) expect([width, height]).toEqual([210, 297])
    expect(sheet.pages[0]!.text).toContain(titles[language].program)

    const cards = await read(two, `card-02-first-drive-cards-${language}-a4.pdf`)
    // Three cards: two sheets of two sides.
    expect(cards.pages.map(({ width, height }) => [width, height])).toEqual(Array(4).fill([297, 210]))
    expect(unbroken(cards.pages[0]!.text)).toContain('botgarten.example.org/school/lab/forward')
    expect(cards.pages[0]!.links).toContain('https://botgarten.example.org/school/lab/forward')

    expect(botgarten(['q-city', '--paper', 'a5', ...said, '--out', one]).status).toBe(0)
    const city = await read(one, `card-06-q-city-${language}-a5.pdf`)
    expect(city.pages.map(({ width, height }) => [width, height])).toEqual(Array(2).fill([148, 210]))
    expect(city.pages[0]!.text).toContain(titles[language].city)
    expect(city.pages[0]!.links).toContain('https://botgarten.example.org/school/lab/city')

    for (const { pages } of [sheet, cards, city])
      for (const { text, missingFonts } of pages) {
        expect(missingFonts).toEqual([])
        expect(text).not.toMatch(foreign[language])
      }
  })

test('botgarten print: a questionnaire with numbers, and with faces', async () => {
  const folder = fresh()
  const call = botgarten([
    'questionnaire-after',
    'questionnaire-after-young',
    '--lang',
    'en',
    '--out',
    folder,
  ])
  expect(call).toMatchObject({ status: 0, stderr: '' })
  const read = (name: string) => readPdf(readFileSync(join(folder, `questionnaire-after${name}-en.pdf`)))
  const [older, young] = [await read(''), await read('-young')]
  for (const { pages } of [older, young])
    for (const { width, height } of pages) expect([width, height]).toEqual([210, 297])
  const textOf = ({ pages }: typeof older) => pages.map(({ text }) => text).join(' ')
  expect(textOf(older)).toContain('Was the topic “Reinforcement learning” difficult to understand?')
  expect(textOf(young)).toContain('Was it easy to understand how Bo learns by trying?')
  expect(young.tagged).toBe(true)
})

test('botgarten print pack: what a lesson needs for 25 children, with a cover; answers in a file of their own', async () => {
  const out = fresh()
  const asked = ['--pupils', '25', '--sets', '2', '--lang', 'de', '--out', out]
  const call = botgarten(['pack', 'lesson-3', ...asked])
  expect(call).toMatchObject({ status: 0, stderr: '' })
  expect(readdirSync(out).sort()).toEqual(['pack-lesson-3-answers-de-a4.pdf', 'pack-lesson-3-de-a4.pdf'])
  const { pages } = await readPdf(readFileSync(join(out, 'pack-lesson-3-de-a4.pdf')))
  const cover = pages[0]!.text
  for (const said of [
    'Freundschaft und Angst',
    '25 Kinder',
    '13 Paare',
    '2 Sätze',
    'NN 5',
    '3.1',
    '3.2',
    'P 3',
  ])
    expect(cover).toContain(said)
  // As many pages as the cover says there are.
  expect(cover).toContain(`${pages.length} Seiten in dieser Datei`)
  expect(pages.flatMap(({ missingFonts }) => missingFonts)).toEqual([])
})

test('botgarten print where no browser starts says what to install, and writes nothing', () => {
  const out = fresh()
  const blind = botgarten(['q-city', '--out', out], { CHROMIUM: join(out, 'no-browser') })
  expect(blind.status).toBe(1)
  expect(blind.stderr).toContain('did not start')
  expect(blind.stderr).toContain('Install Chrome, Chromium or Edge')
  expect(readdirSync(out)).toEqual([])
})

test('the table of trials is printed filled, and nothing else of the lab', async ({ child, page }) => {
  const learner = new Learner(child)
  await learner.opens('railway')
  await learner.guesses(5, 0, 1)
  await child.presses('q.guessing.learn')
  await learner.hurries()
  await child.presses('q.inside')
  await learner.turnsTo('trials')
  const asked = page.evaluate(
    () => new Promise((done) => window.addEventListener('beforeprint', () => done(true))),
  )
  await child.presses('q.print')
  expect(await asked).toBe(true)
  const { pages } = await readPdf(await page.pdf({ preferCSSPageSize: true }))
  expect(pages).toHaveLength(1)
  const [{ text, width, height }] = pages as [(typeof pages)[0]]
  expect([width, height]).toEqual([297, 210])
  for (const said of [child.word('q.printedTitle'), child.word('q.task', { start: 3, goal: 1 }), '3-5-0-1'])
    expect(text).toContain(said)
  expect(text).not.toContain(child.word('q.csv'))
})

test('a card printed by hand from its page is as large as its paper, without what is around it', async ({
  page,
}) => {
  // By address: a code on paper.
  await page.goto('/materials/card/meet-bo')
  await expect(page.locator('.material[aria-busy=false]')).toBeVisible()
  const { pages } = await readPdf(await page.pdf({ preferCSSPageSize: true, printBackground: true }))
  expect(pages.map(({ width, height }) => [width, height])).toEqual(Array(2).fill([148, 210]))
  // The bar over the page lets choose a language.
  expect(pages[0]!.text).not.toMatch(/\bDE\b|\bEN\b/)
  expect(unbroken(pages[1]!.text)).toContain('/lab/chameleon')
})
