// Rooms: teacher, trust
// By address: a teacher comes by a bookmark of the own page.
import type { Page } from '@playwright/test'
import { serverWithData, firstTeacher, nextClass } from '../class-server.ts'
import { expect, test as base } from '../house.ts'
import { teaches } from '../made-class.ts'
import { readPdf } from '../pdf.ts'
import { opensView } from '../screens-teacher.ts'
import { languagesOf } from '../words.ts'

type School = Awaited<ReturnType<typeof nextClass>>

const test = base.extend<{ school: School }>({
  // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of fixtures from the pattern
  school: async ({}, use) => {
    const server = await serverWithData()
    const school = await nextClass({ ...server, teacher: await firstTeacher(server) }, 'en')
    await use(school)
    await server.close()
  },
  baseURL: ({ school }, use) => use(school.url),
  complaints: [/^A request to http:\/\/localhost:\d+\//],
})

/** The text of the only page that is printed. */
async function printed(page: Page): Promise<string> {
  const { pages } = await readPdf(await page.pdf({ preferCSSPageSize: true }))
  expect(pages).toHaveLength(1)
  return pages[0]!.text.replaceAll(/\s+/g, ' ')
}

for (const language of languagesOf(import.meta.filename))
  test.describe(`a sheet is printed alone, in ${language}`, () => {
    test.use({ language })

    test('the letter to parents', async ({ child, page, school }) => {
      await opensView(child, school, 'data')
      await child.presses('teacher.forParents')
      const letter = await printed(page)
      expect(letter).toContain(child.word('teacher.parents.title'))
      expect(letter).toContain(child.word('teacher.parents.rights').slice(0, 40))
      for (const other of ['teacher.export', 'teacher.print', 'parts.close'])
        expect(letter).not.toContain(child.word(other))
    })

    test('the phrase of the backups, with the address of its server', async ({ child, page, school }) => {
      await teaches(page, school)
      await page.goto('/teacher/health')
      await child.presses('teacher.phrase.show')
      const words = await page.getByText(/^(?:[a-z]+-){9}[a-z]+$/).innerText()
      const sheet = await printed(page)
      expect(sheet.replaceAll(' ', '')).toContain(words)
      expect(sheet).toContain(new URL(school.url).host)
      for (const other of ['teacher.health', 'teacher.forOperators', 'teacher.print'])
        expect(sheet).not.toContain(child.word(other))
    })
  })
