import { leftEye, leftWheel } from '../../child.ts'
import { Pupil } from '../../child-class.ts'
import { joins, saves, signsIn } from '../../made-class.ts'
import { expect, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en', complaints: [/status of 4\d\d|net::ERR_FAILED/] })

const hides = /(?<=class=|\?p=)[\w-]+/g

test('work in a class, step by step', { tag: '@class' }, async ({ child, page, school }) => {
  const fox = await joins(school, 'Fuchs')
  const me = new Pupil(child, school)
  const dialog = page.getByRole('dialog')
  const saving = '**/api/class/projects/**'
  const cloud = () => expect(me.chip('chipClass')).toBeVisible()
  const opensMenu = async (key: string) => {
    await me.opensMenu()
    await child.presses(`class.${key}`)
  }
  await saves(fox)
  await signsIn(page, school, fox)
  await child.opensLab('friendship')
  await cloud()
  await goesThrough(
    child,
    'class-lab',
    {
      'why the work is in the class': () => me.chip('chipClass').click(),
      'that is all right': () => child.presses('parts.ok'),
      'the class is away': async () => {
        await page.route(saving, (route) => route.abort())
        await child.typesWeight(leftEye, leftWheel, 0.3)
        await me.chip('chipHere').click()
        await expect(dialog).toBeVisible()
      },
      'it is still away': async () => {
        await child.types('Escape')
        await expect(dialog).toHaveCount(0)
      },
      'the class is there again': async () => {
        await me.chip('chipHere').click()
        await page.unroute(saving)
        await child.presses('class.tryAgain')
        await cloud()
      },
      'the versions': async () => {
        await opensMenu('versions')
        await expect(dialog.getByRole('button', { name: child.word('class.takeVersion') })).toBeVisible()
      },
      'the first version': async () => {
        await dialog.getByRole('listitem').last().getByRole('button').click()
        await expect(dialog.getByText(child.word('class.placesDone', { passed: 1, of: 3 }))).toBeVisible()
      },
      'the versions are closed': () => child.presses('class.close'),
      'the first version is taken back': async () => {
        await opensMenu('versions')
        await dialog.getByRole('listitem').last().getByRole('button').click()
        await child.presses('class.takeVersion')
        await expect(dialog).toHaveCount(0)
        await child.seesWeight(leftEye, leftWheel, 0.8)
        await cloud()
      },
      'another device has changed it, too': async () => {
        await saves(fox, { base: 3, starts: [0, 1], program: 'start' })
        await child.typesWeight(leftEye, leftWheel, 0.5)
        await expect(dialog.getByRole('heading', { level: 2 })).toHaveCount(2)
      },
      'later, please': () => child.presses('class.laterChoose'),
      'the question again': async () => {
        await me.chip('chipConflict').click()
        await expect(dialog.getByRole('heading', { level: 2 })).toHaveCount(2)
      },
      'the own version goes on': async () => {
        await dialog
          .getByRole('button', { name: child.word('class.goOnWithThis') })
          .first()
          .click()
        await expect(dialog).toHaveCount(0)
        await cloud()
      },
    },
    { hides },
  )
})
