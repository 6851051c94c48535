// Rooms: class, teacher, gallery, questionnaires, races, server
// axe in every state of a class: of pupils, teachers and the first start. The other states: axe-lab, axe-learning, axe-pages.
import { opensForm } from '../asked-class.ts'
import { findsNothing } from '../axe.ts'
import { Pupil } from '../child-class.ts'
import { Asker, nth } from '../child-questionnaires.ts'
import { GalleryHands, sharesOne } from '../child-gallery.ts'
import { Child } from '../child.ts'
import { serverWithData } from '../class-server.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, saves, signsIn, teaches, works, type MadeClass } from '../made-class.ts'
import { pupilScreens } from '../screens-class.ts'
import { startScreens } from '../screens-start.ts'
import { teacherScreens } from '../screens-teacher.ts'

interface ClassState {
  readonly name: string
  show(child: Child, made: MadeClass): Promise<unknown>
}

const test = testInClass()
test.use({
  complaints: [
    /401 \(Unauthorized\)|403 \(Forbidden\)|409 \(Conflict\)|410 \(Gone\)|423 \(Locked\)|^A request to http:\/\/localhost:\d+\//,
  ],
})

/** States that `npm run pictures` shows too, by their names there. */
const screens = [
  ...['join-nickname', 'join-pictures', 'join-return-wrong', 'are-you', 'hand-up', 'class-versions'],
  ...['two-devices', 'class-ended', 'class-hidden', 'attention', 'from-teacher', 'closed-card', 'free-today'],
  ...['gallery', 'gallery-brain', 'gallery-share', 'class-gallery', 'together'],
  ...[
    'teacher-health',
    'teacher-clock',
    'teacher-backup-phrase',
    'teacher-account',
    'teacher-account-delete',
    'class-projector-wifi',
    'class-wifi',
    'class-look-inside',
    'class-matrix',
  ],
  ...['class-pupils', 'class-data', 'class-questionnaires', 'class-results', 'class-question-code'],
]
const all: readonly ClassState[] = [...pupilScreens, ...teacherScreens]
const shown = (name: string) => {
  const screen = all.find((one) => one.name === name)
  if (!screen) throw new Error(`There is no screen ${name}`)
  return screen
}

const pixel = {
  type: 'image/png',
  base64: 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==',
}

/** States without a picture. */
const others: readonly ClassState[] = [
  {
    name: 'a pupil is back by its pictures on another device',
    async show(child, made) {
      const { pictures, nickname } = await joins(made, 'Fuchs')
      const pupil = new Pupil(child, made)
      await pupil.opensByLink()
      await pupil.returns(nickname)
      await pupil.taps(...pictures.map((one) => child.word(`class.picture.${one}`)))
      await expect(child.words('class.workIsHere')).toBeVisible()
    },
  },
  {
    name: 'the class is closed while a pupil works: the pictures are asked',
    async show(child, made) {
      await signsIn(child.page, made, await joins(made, 'Fuchs'))
      await child.opensLab('friendship')
      await made.teacher.ask('POST', `/classes/${made.id}/close`)
      await expect(child.words('class.whichPictures')).toBeVisible()
    },
  },
  {
    name: 'what was shared drives on the page',
    async show(child, made) {
      await sharesOne(await joins(made, 'Eule'), 'Slow and safe')
      await signsIn(child.page, made, await joins(made, 'Fuchs'))
      const gallery = new GalleryHands(child)
      await gallery.opens()
      await gallery.looks('Slow and safe')
      await child.presses('gallery.watch')
      await expect(child.button('gallery.pause')).toBeVisible()
    },
  },
  {
    name: 'a project is shared from the lab',
    async show(child, made) {
      await signsIn(child.page, made, await joins(made, 'Fuchs'))
      await child.opensLab('friendship')
      await child.presses('lab.hint')
      await expect(new Pupil(child, made).chip('chipClass')).toBeVisible()
      await child.presses('lab.menu')
      await child.presses('parts.shareInClass')
      await expect(child.page.getByRole('dialog').getByLabel(child.word('gallery.title'))).toBeVisible()
    },
  },
  {
    name: 'a teacher looks at a photo that waits',
    async show(child, made) {
      const more = { assets: { ['b'.repeat(64)]: pixel } }
      await sharesOne(await joins(made, 'Eule'), 'With a photo', { more })
      await teaches(child.page, made)
      // By address: a teacher comes by a bookmark.
      await child.page.goto(`/teacher?class=${made.id}&view=gallery`)
      await child.page.getByLabel(child.word('teacher.galleryShow')).selectOption('waiting')
      await child.page.getByRole('button', { name: 'With a photo', exact: true }).click()
      await expect(child.page.getByRole('img', { name: child.word('teacher.galleryPhoto') })).toBeVisible()
    },
  },
  {
    name: 'a classmate asks',
    async show(child, made) {
      const [fox, owl] = [await joins(made, 'Fuchs'), await joins(made, 'Eule')]
      await saves(owl, { starts: [0, 1, 2] })
      await made.teacher.ask('PUT', `/classes/${made.id}/gallery`, { asking: true })
      await signsIn(child.page, made, owl)
      await child.opensHome()
      await expect
        .poll(async () => {
          await works(owl.asker, 0)
          return (await fox.asker.ask('PUT', '/me/question', { card: 'friendship', to: owl.id })).status
        })
        .toBeLessThan(300)
      await expect(child.button('class.mateYes')).toBeVisible()
    },
  },
  {
    name: 'a pupil has answered all that was asked',
    async show(child, made) {
      await opensForm(made, 'after')
      await signsIn(child.page, made, await joins(made, 'Kiwi'))
      await child.page.goto('/')
      await child.page.getByRole('link', { name: child.word('class.askedGo'), exact: true }).click()
      await expect(child.words('form.codeTitle')).toBeVisible()
      await child.presses('form.codeForgot')
      await new Asker(child).fillsIn('after', false, nth(0))
    },
  },
  {
    name: 'a race with the brains of a class',
    async show(child, made) {
      await teaches(child.page, made)
      // By address: a teacher comes by a bookmark.
      await child.page.goto(`/teacher/projector?class=${made.id}`)
      await child.page.getByRole('link', { name: child.word('teacher.brainRace'), exact: true }).click()
      await expect(child.button('race.brains.ready')).toBeVisible()
    },
  },
  {
    name: 'a hint was sent to a pupil',
    async show(child, made) {
      await shown('class-live').show(child, made)
      await child.page.getByRole('button', { name: '2', exact: true }).click()
      await child.presses('teacher.sendHint', { number: 2, name: 'Blitz' })
      await expect(child.words('teacher.hintSent', { name: 'Blitz' })).toBeVisible()
    },
  },
]

for (const state of [...screens.map(shown), ...others])
  test(`axe finds nothing in a class: ${state.name}`, ({ child, school }) =>
    findsNothing(child, { [state.name]: () => state.show(child, school) }))

for (const name of ['account', 'wifi', 'phrase', 'done', null]) {
  const screen = startScreens.find((one) => one.name === (name ? `first-start-${name}` : 'first-start'))!
  test(`axe finds nothing where a teacher starts: ${screen.name}`, async ({
    browser,
    contextOptions,
    locale,
  }) => {
    const server = await serverWithData()
    const context = await browser.newContext({ ...contextOptions, baseURL: server.url, locale })
    const child = new Child(await context.newPage(), 'en')
    await findsNothing(child, { [screen.name]: () => screen.show(child, server) })
    await context.close()
    await server.close()
  })
}

test.describe('in German', () => {
  test.use({ language: 'de' })
  test('axe finds nothing among the pupils of a class', async ({ child, school }) =>
    findsNothing(child, { pupils: () => shown('class-pupils').show(child, school) }))
})
