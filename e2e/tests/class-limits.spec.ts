// Rooms: class
import { Pupil } from '../child-class.ts'
import { ProjectList } from '../child-projects.ts'
import { leftEye, leftWheel } from '../child.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { anotherClass, joins, signsIn } from '../made-class.ts'
import { projectFile } from '../projects.ts'
import { languagesOf } from '../words.ts'

const test = testInClass()
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })
// The class refuses one pupil and one project too many, and a browser complains of it.
test.use({ complaints: [/409 \(Conflict\)|422 \(Unprocessable/] })

for (const language of languagesOf(import.meta.filename))
  test.describe(`the limits of a class, in ${language}`, () => {
    test.use({ language })

    test('the 101st pupil is refused with a reason', async ({ child, school: server }) => {
      const school = await anotherClass(server)
      for (let count = 0; count < 100; count++) await joins(school, `Kind ${count}`)
      const late = new Pupil(child, school)
      await late.opens()
      await late.nickname.fill('Fuchs')
      await child.presses('class.join')
      await expect(child.words('class.refused.classHasAll')).toBeVisible()
    })

    test('the 101st project of a child waits, and comes into the class once another one is deleted', async ({
      child,
      page,
      school: server,
    }) => {
      const school = await anotherClass(server)
      const made = await joins(school, 'Fuchs')
      const project = JSON.parse(projectFile('friendship', 'start')) as object
      for (let count = 1; count <= 100; count++) {
        const path = `/projects/project-friendship-${count}?base=0&save=save-${1000 + count}`
        const { status } = await made.asker.ask('PUT', path, { ...project, name: `Garden ${count}` })
        expect(status).toBe(200)
      }
      await signsIn(page, school, made)
      const pupil = new Pupil(child, school)
      await child.opensLab('fear')
      await child.typesWeight(leftEye, leftWheel, 0.5)
      await pupil.chip('chipHere').click()
      await expect(page.getByRole('dialog')).toContainText(child.word('class.whyTooManyProjects'))
      await page.keyboard.press('Escape')

      const list = new ProjectList(child)
      await list.opens()
      await list.chooses('Garden 7', 'throw')
      await list.hears('projects.thrown', { name: 'Garden 7' })
      await child.opensLab('fear')
      await expect(pupil.chip('chipClass')).toBeVisible()
      const { body } = await made.asker.ask('GET', '/projects')
      const ids = (body as { projects: readonly { id: string }[] }).projects.map(({ id }) => id)
      expect(ids).toHaveLength(100)
      expect(ids).toContain('project-fear')
    })
  })
