import type { Child } from '../child.ts'
import { joins, saves, teaches } from '../made-class.ts'
import { expect, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en', complaints: [/status of 4\d\d/] })

/** Ids, links, days of the calendar, and the words of a code. */
const hides =
  /(?<=class(?:es\/|=)|pupils\/|substitute#)[\w-]+|\d{4}-\d\d-\d\d|(?<=paragraph: )[a-z ]+$|\b(?:Tree|Cup|Boat|Star|House|Fish|Leaf|Key|Sun|Ball|Flag|Moon)$/g

async function prints({ page }: Child, press: () => Promise<void>) {
  await page.evaluate(() => (window.print = () => (document.title = 'printed')))
  await press()
  await expect(page).toHaveTitle('printed')
}

test('the data of a class, step by step', { tag: '@teacher' }, async ({ child, page, school }) => {
  const dialog = page.getByRole('dialog')
  const endsOn = page.getByLabel(child.word('teacher.endsOn'), { exact: true })
  await saves(await joins(school, 'Ada'))
  await teaches(page, school)
  // By address: the class is another one in every run.
  await page.goto(`/teacher?class=${school.id}`)
  await goesThrough(
    child,
    'teacher-data',
    {
      'what is kept': async () => {
        await child.presses('teacher.data')
        await expect(page.getByRole('table')).toBeVisible()
      },
      'a text for parents': () => child.presses('teacher.forParents'),
      'it is printed': async () => {
        await prints(child, () => dialog.getByRole('button', { name: child.word('teacher.print') }).click())
        await child.presses('parts.close')
        await expect(dialog).toHaveCount(0)
        await page.reload()
        await child.seesTitle()
        await child.presses('teacher.moveDate')
      },
      'the class ends soon': async () => {
        await expect(endsOn).toHaveAttribute('min', /\d/)
        await endsOn.fill(school.classServer.ports.day(10))
        await child.presses('teacher.save')
      },
      'the date is moved from another view': async () => {
        await child.presses('teacher.live')
        await expect(child.button('teacher.attention')).toBeVisible()
        await child.presses('teacher.moveDate')
        await child.button('teacher.moveDate').nth(1).click()
      },
      'another name is typed': () => page.getByLabel(child.word('teacher.typeName')).fill('5a'),
      'its name is typed': () => page.getByLabel(child.word('teacher.typeName')).fill('5b'),
    },
    { hides },
  )
  await child.presses('teacher.deleteAll', { name: '5b' })
  await expect(child.words('teacher.myClasses')).toBeVisible()
})
