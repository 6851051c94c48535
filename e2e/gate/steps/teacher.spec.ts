import type { Page } from '@playwright/test'
import { joins, saves, teaches, type MadeClass } from '../../made-class.ts'
import { projectFile } from '../../projects.ts'
import { expect, opensProject, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en', complaints: [/status of 4\d\d|ERR_INTERNET_DISCONNECTED/] })

const at = (checks: readonly string[], more: object = {}) => ({
  ...{ card: 'friendship', project: 'project-friendship', checks, failed: 0, running: true, idle: 0 },
  ...{ size: [600, 400], pose: { x: 360, y: 210, heading: 200 }, trail: [440, 250, 420, 240, 380, 220] },
  ...more,
})

/** Pupils, the reports of their pages, and the text of their tiles. */
const pupils: readonly (readonly [name: string, report: object | null, said: RegExp])[] = [
  ['Ada', at(['passed', 'failed', 'open'], { failed: 2 }), /Friendship.*hand up/],
  ['Ben', at(['passed', 'passed', 'passed'], { pose: null }), /Friendship.*all done/],
  ['Cleo', at(['open', 'failed'], { failed: 6, card: 'rally' }), /Rally.*same check 6 times/],
  ['Dan', at(['open', 'open', 'open'], { idle: 240 }), /Friendship.*no change/],
  ['Eve', null, /no card yet.*not here yet/],
  ['Fred', at([], { card: null }), /new.*own card or project/],
]

const hides = /\d+ (?:s|min) ago|(?<=class=)[\w-]+/g

const tile = (page: Page, name: string) =>
  page.getByRole('listitem').filter({ hasText: name }).getByRole('button').first()

/** All come. @returns the timer of their reports: a pupil who was not heard of for 20 s is away. */
async function arrive(school: MadeClass) {
  const all: (() => Promise<unknown>)[] = []
  for (const [name, report] of pupils) {
    const pupil = await joins(school, name)
    if (name === 'Ada') await saves(pupil)
    if (report) all.push(() => pupil.asker.ask('PUT', '/me/here', report))
    await all.at(-1)?.()
    if (name === 'Ada') await pupil.asker.ask('PUT', '/me/hand', { up: true })
  }
  return setInterval(() => void Promise.all(all.map((reports) => reports())), 5000)
}

/** Parts of a drawing without their shape, which a tree for screen readers does not show. */
const shapeless = ['svg:not([viewBox])', 'rect:not([fill])', 'polyline:not([points])', 'img:not([src])']

test('a class live, step by step', { tag: '@teacher' }, async ({ child, page, school }) => {
  const dialog = page.getByRole('dialog')
  let reports: NodeJS.Timeout | undefined
  const ownHint = page.getByRole('textbox', { name: child.word('teacher.ownHint') })
  await opensProject(child, 'Mine', projectFile('friendship', 'start').replace('"Friendship"', '"Mine"'))
  await teaches(page, school)
  // By address: the class is another one in every run.
  await page.goto(`/teacher?class=${school.id}`)
  await goesThrough(
    child,
    'teacher-live',
    {
      'nobody is here': () => expect(child.words('teacher.nobodyYet')).toBeVisible(),
      'the lesson is over': () => school.teacher.ask('POST', `/classes/${school.id}/close`),
      'the class is opened': () => child.presses('teacher.openLesson'),
      'six pupils come': async () => {
        reports = await arrive(school)
        for (const [name, , said] of pupils) await expect(tile(page, name)).toContainText(said)
        await expect(tile(page, 'Ben').getByRole('img')).toHaveAccessibleName('3 of 3 checks passed')
        for (const part of shapeless) await expect(page.locator(`.picture ${part}`)).toHaveCount(0)
      },
      'a tile is chosen': () => tile(page, 'Ada').click(),
      'the second hint is chosen': () => page.getByRole('button', { name: '2', exact: true }).click(),
      'the hint is sent': () => child.presses('teacher.sendHint', { number: 2, name: 'Ada' }),
      'own words are chosen': () => child.presses('teacher.myOwn'),
      'own words are sent': async () => {
        await ownHint.fill('Look at its wheels.')
        await child.presses('teacher.sendOwn', { name: 'Ada' })
        await expect(ownHint).toHaveValue('')
      },
      'more is typed': () => ownHint.fill('And at its eyes.'),
      'help is for all': () => child.presses('teacher.allOf', { count: 6 }),
      'all get a hint': async () => {
        await ownHint.fill('Clean up, please.')
        await child.presses('teacher.sendAll')
      },
      'a program for all is chosen': async () => {
        await child.presses('teacher.sendProgram')
        await expect(dialog.locator('optgroup[label]')).toHaveCount(2)
      },
      'no program is sent': () => child.presses('parts.close'),
      'help is for one': () => page.getByRole('button', { name: 'Ada', exact: true }).click(),
      'a program for one is sent': async () => {
        await child.presses('teacher.sendProgram')
        await child.presses('teacher.send')
      },
      'an own program is chosen': () => dialog.getByRole('combobox').selectOption('Mine'),
      'the own program is sent': () => child.presses('teacher.send'),
      'the dialog is left by a key': () => child.types('Escape'),
      'the teacher looks inside': async () => {
        await child.presses('teacher.look')
        await expect(dialog.getByRole('img')).toHaveCount(2)
      },
      'the teacher looks away': () => child.presses('parts.close'),
      'the hand is taken down': () => child.presses('teacher.handDown'),
      'another tile is chosen': () => tile(page, 'Cleo').click(),
      'nothing was saved there': async () => {
        await child.presses('teacher.look')
        await expect(child.words('teacher.nothingSaved')).toBeVisible()
      },
      'the teacher looks away by a key': () => child.types('Escape'),
      'a pupil with all checks passed': () => tile(page, 'Ben').click(),
      'a pupil without a card': () => tile(page, 'Fred').click(),
      'no tile is chosen': () => tile(page, 'Fred').click(),
      'attention is called': () => child.presses('teacher.attention'),
      'they go on': () => child.presses('teacher.goOn'),
    },
    { hides },
  )
  clearInterval(reports)
})

test(
  'cards that are free, and a class that ends, step by step',
  { tag: '@teacher' },
  async ({ child, page, school }) => {
    const dialog = page.getByRole('dialog')
    const box = (name: string) => dialog.getByRole('checkbox', { name, exact: true })
    const level = (name: string) => dialog.getByRole('radio', { name: child.word(`teacher.level.${name}`) })
    const path = `/classes/${school.id}`
    await joins(school, 'Ada')
    await teaches(page, school)
    // By address: the class is another one in every run.
    await page.goto(`/teacher?class=${school.id}`)
    await goesThrough(
      child,
      'teacher-free',
      {
        'all cards are free': () => expect(tile(page, 'Ada')).toBeVisible(),
        'the cards are looked at': () => child.presses('teacher.change'),
        'a bed is closed': () => dialog.getByRole('checkbox').first().uncheck(),
        'a card is free again': () => box(child.card('forward')).check(),
        'another one is closed': () => box('Friendship').uncheck(),
        'simple blocks': () => level('plain').check(),
        'nothing is changed': () => child.presses('teacher.cancel'),
        'a few cards are free': async () => {
          await child.presses('teacher.change')
          for (const all of (
            await dialog.getByRole('checkbox', { name: child.word('teacher.allCards') }).all()
          ).slice(1))
            await all.uncheck()
          await level('all').check()
          await child.presses('teacher.save')
          await expect(dialog).toHaveCount(0)
        },
        'all is free again': async () => {
          await child.presses('teacher.change')
          for (const all of await dialog
            .getByRole('checkbox', { name: child.word('teacher.allCards') })
            .all())
            await all.check()
          await level('own').check()
          await child.presses('teacher.save')
          await expect(dialog).toHaveCount(0)
        },
        'the lesson is over': () => school.teacher.ask('POST', `${path}/close`),
        'a hint is refused': async () => {
          await page.getByRole('textbox').fill('Hello')
          await child.presses('teacher.sendAll')
        },
        'the lesson goes on': () => child.presses('teacher.openLesson'),
        'the connection is lost': () => page.context().setOffline(true),
        'the connection is back': () => page.context().setOffline(false),
        'the cards are changed at last': async () => {
          await child.presses('teacher.change')
          await school.teacher.ask('DELETE', path, { name: '5b' })
          await expect(page.getByText(child.word('teacher.streamEnded'))).toBeVisible()
        },
        'they cannot be changed': () => child.presses('teacher.save'),
      },
      { hides },
    )
  },
)
