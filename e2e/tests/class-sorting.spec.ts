// Rooms: class, sorting, storage
import { ProjectList } from '../child-projects.ts'
import { Pupil } from '../child-class.ts'
import { SortingHands } from '../child-sorting.ts'
import { Child } from '../child.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, signsIn, type Joined, type MadeClass } from '../made-class.ts'
import { checkProject as checkOfEarlier } from '../samples/a62d0d78/check-project.mjs'
import { languagesOf } from '../words.ts'

const test = testInClass()
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

/** The projects of a pupil, as the teacher of the class reads them. */
async function readsOf({ teacher, id }: MadeClass, pupil: Joined) {
  const path = `/classes/${id}/pupils/${pupil.id}/projects`
  const { projects } = (await teacher.ask('GET', path)).body as {
    projects: readonly { readonly id: string; readonly name: string }[]
  }
  return { path, projects }
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`sorting in a class, in ${language}`, () => {
    test.use({ language })

    test('the class takes the project; another device and the teacher open it', async ({
      browser,
      child,
      contextOptions,
      house,
      locale,
      page,
      school,
    }) => {
      const fox = await joins(school, 'Fuchs')
      await signsIn(page, school, fox)
      await new SortingHands(child).makesMarbles()
      await expect(new Pupil(child, school).chip('chipClass')).toBeVisible()

      const device = async () => {
        const context = await browser.newContext({ ...contextOptions, baseURL: house, locale })
        return { context, there: new Child(await context.newPage(), language) }
      }
      await test.step('another device of the pupil', async () => {
        const { context, there } = await device()
        await signsIn(there.page, school, fox)
        await new ProjectList(there).opens()
        await there.page.getByRole('link', { name: 'Marbles', exact: true }).click()
        await new SortingHands(there).seesMarbles()
        await context.close()
      })

      await test.step('the teacher', async () => {
        const { path, projects } = await readsOf(school, fox)
        expect(projects.map(({ name }) => name)).toEqual(['Marbles'])
        const { project } = (await school.teacher.ask('GET', `${path}/${projects[0]!.id}`)).body as {
          project: object
        }
        expect(project).toMatchObject({ botgarten: 5, playground: 'sorting' })
        const { context, there } = await device()
        await there.opensHome()
        await there.opensFileAtHome('Marbles.botgarten.json', JSON.stringify(project))
        await new SortingHands(there).seesMarbles()
        await context.close()
      })
    })

    test.describe('by a server from before there were projects of sorting', () => {
      test.use({ complaints: [/422 \(Unprocessable/] })

      test('it is refused with a sentence and stays on the device, until the server is new', async ({
        child,
        page,
        school,
      }) => {
        const { ports } = school.classServer
        const { checkProject } = ports
        try {
          Object.assign(ports, { checkProject: (text: string) => Promise.resolve(checkOfEarlier(text)) })
          const owl = await joins(school, 'Eule')
          const pupil = new Pupil(child, school)
          await signsIn(page, school, owl)
          const sorting = new SortingHands(child)
          await sorting.makesMarbles()
          await pupil.chip('chipHere').click()
          await expect(page.getByRole('dialog')).toContainText(child.word('class.whyNewer'))
          await child.types('Escape')
          expect((await readsOf(school, owl)).projects).toEqual([])
          await page.reload()
          await sorting.seesMarbles()
        } finally {
          Object.assign(ports, { checkProject })
        }
        await new SortingHands(child).group(2).fill('Yours')
        await expect(new Pupil(child, school).chip('chipClass')).toBeVisible()
      })
    })
  })
}
