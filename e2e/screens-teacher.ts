import { expect, type Page } from '@playwright/test'
import type { Child } from './child.ts'
import type { serverWithData } from './class-server.ts'
import { fills, teaches, type MadeClass } from './made-class.ts'
import type { ClassScreen } from './screens-class.ts'

type EmptyServer = Awaited<ReturnType<typeof serverWithData>>
type View = 'live' | 'cards' | 'class' | 'data'

const opensView = async (child: Child, made: MadeClass, view: View) => {
  await teaches(child.page, made)
  await child.page.goto(`/teacher?class=${made.id}&view=${view}`)
  await expect(child.page.getByRole('navigation', { name: child.word('teacher.views') })).toBeVisible()
}

async function opensClass(child: Child, made: MadeClass, view: View) {
  await fills(made)
  await opensView(child, made, view)
}

const tile = (page: Page, name: string) =>
  page.getByRole('listitem').filter({ hasText: name }).getByRole('button').first()

/** The live view with the tile of who raises the hand chosen. */
async function choosesBlitz(child: Child, made: MadeClass) {
  await opensClass(child, made, 'live')
  await tile(child.page, 'Blitz').click()
  await expect(child.button('teacher.look')).toBeVisible()
}

const inDialog = (child: Child) => expect(child.page.getByRole('dialog')).toBeVisible()

const opensMenu = async (child: Child, made: MadeClass) => {
  await fills(made, 3)
  await opensView(child, made, 'class')
  await child.presses('teacher.more', { name: 'Biber 3' })
}

const live: readonly ClassScreen[] = [
  { name: 'class-live-empty', show: (child, made) => opensView(child, made, 'live') },
  {
    name: 'class-live-closed',
    async show(child, made) {
      await fills(made, 3)
      await made.teacher.ask('POST', `/classes/${made.id}/close`)
      await opensView(child, made, 'live')
    },
  },
  {
    name: 'class-live-some',
    async show(child, made) {
      await fills(made, 5)
      await opensView(child, made, 'live')
      await expect(tile(child.page, 'Donut')).toBeVisible()
    },
  },
  { name: 'class-live', show: choosesBlitz },
  {
    name: 'class-live-own-hint',
    async show(child, made) {
      await choosesBlitz(child, made)
      await child.presses('teacher.myOwn')
      await child.page.getByLabel(child.word('teacher.ownHint')).fill('Schau auf das linke Rad.')
    },
  },
  {
    name: 'class-live-all',
    async show(child, made) {
      await choosesBlitz(child, made)
      await child.presses('teacher.allOf', { count: 24 })
    },
  },
  {
    name: 'class-attention',
    async show(child, made) {
      await choosesBlitz(child, made)
      await child.presses('teacher.attention')
      await expect(child.button('teacher.goOn')).toBeVisible()
    },
  },
  {
    name: 'class-look-inside',
    async show(child, made) {
      await opensClass(child, made, 'live')
      await tile(child.page, 'Ananas').click()
      await child.presses('teacher.look')
      await expect(child.page.getByRole('dialog').getByRole('img')).toHaveCount(2)
    },
  },
  {
    name: 'class-free-cards',
    async show(child, made) {
      await opensClass(child, made, 'live')
      await child.presses('teacher.change')
      await inDialog(child)
    },
  },
  {
    name: 'class-start-program',
    async show(child, made) {
      await choosesBlitz(child, made)
      await child.presses('teacher.sendProgram')
      await inDialog(child)
    },
  },
]

const lists: readonly ClassScreen[] = [
  {
    name: 'class-matrix',
    async show(child, made) {
      const cards = ['forward', 'square', 'stop', 'chameleon', 'incognito', 'friendship', 'fear', 'rally']
      await made.teacher.ask('PUT', `/classes/${made.id}/free`, { cards, level: 'plain' })
      await opensClass(child, made, 'cards')
      await child.page.getByRole('button', { name: 'Blitz', exact: true }).click()
    },
  },
  {
    name: 'class-matrix-print',
    async show(child, made) {
      await opensClass(child, made, 'cards')
      await expect(child.page.getByRole('table')).toBeVisible()
      await child.page.emulateMedia({ media: 'print' })
    },
  },
  {
    name: 'class-pupils',
    async show(child, made) {
      await opensClass(child, made, 'class')
      await expect(child.page.getByText('Zebra')).toBeVisible()
    },
  },
  { name: 'class-pupils-empty', show: (child, made) => opensView(child, made, 'class') },
  { name: 'class-pupil-menu', show: opensMenu },
  ...(['rename', 'newPictures', 'remove'] as const).map((entry): ClassScreen => ({
    name: `class-pupil-${entry}`,
    async show(child, made) {
      await opensMenu(child, made)
      await child.presses(`teacher.${entry}`)
      await inDialog(child)
      if (entry !== 'newPictures') return
      await child.page
        .getByRole('dialog')
        .getByRole('button', { name: child.word('teacher.newPictures') })
        .click()
      await expect(child.page.getByRole('dialog').getByRole('listitem')).toHaveCount(3)
    },
  })),
  {
    name: 'class-data',
    async show(child, made) {
      await opensClass(child, made, 'data')
      await child.page.getByLabel(child.word('teacher.typeName')).fill('5b')
    },
  },
  {
    name: 'class-data-date',
    async show(child, made) {
      await opensClass(child, made, 'data')
      await child.presses('teacher.moveDate')
    },
  },
  {
    name: 'class-parents',
    async show(child, made) {
      await opensClass(child, made, 'data')
      await child.presses('teacher.forParents')
      await inDialog(child)
    },
  },
]

const account: readonly ClassScreen[] = [
  {
    name: 'teacher-sign-in',
    async show(child) {
      await child.page.goto('/teacher')
      await child.seesTitle()
    },
  },
  {
    name: 'teacher-wrong-password',
    async show(child) {
      await child.page.goto('/teacher')
      await child.page.getByLabel(child.word('teacher.username'), { exact: true }).fill('m.weber')
      await child.page.getByLabel(child.word('teacher.password'), { exact: true }).fill('falsch')
      await child.presses('teacher.signIn')
      await expect(child.page.getByRole('alert').locator('p')).toBeVisible()
    },
  },
  {
    name: 'teacher-link-used',
    async show(child) {
      await child.page.goto('/teacher/start')
      await child.seesTitle()
    },
  },
  {
    name: 'teacher-classes',
    async show(child, made) {
      const day = made.classServer.ports.day(10)
      await made.teacher.ask('POST', '/classes', {
        name: '8a Informatik',
        language: 'de',
        grade: 8,
        endsOn: day,
      })
      await teaches(child.page, made)
      await child.page.goto('/teacher')
      await expect(child.page.getByText('8a Informatik')).toBeVisible()
    },
  },
  {
    name: 'teacher-new-class',
    async show(child, made) {
      await teaches(child.page, made)
      await child.page.goto('/teacher')
      await child.presses('teacher.newClass')
    },
  },
  {
    name: 'teacher-menu',
    async show(child, made) {
      await opensView(child, made, 'live')
      await child.presses('teacher.person', { name: 'm.weber' })
    },
  },
  {
    name: 'teacher-invite',
    async show(child, made) {
      await opensView(child, made, 'live')
      await child.presses('teacher.person', { name: 'm.weber' })
      await child.presses('teacher.invite')
      await expect(child.page.getByRole('dialog').getByRole('textbox')).toBeVisible()
    },
  },
  {
    name: 'substitute-link',
    async show(child, made) {
      await opensView(child, made, 'class')
      await child.presses('teacher.substituteMake')
      await expect(child.page.getByRole('img', { name: child.word('teacher.substituteQr') })).toBeVisible()
    },
  },
  {
    name: 'substitute',
    async show(child, made) {
      await fills(made, 9)
      const { body } = await made.teacher.ask('POST', `/classes/${made.id}/substitute`)
      await child.page.goto(`/teacher/substitute#${(body as { token: string }).token}`)
      await expect(tile(child.page, 'Donut')).toBeVisible()
    },
  },
]

const wall = [{ width: 1920, height: 1080 }]

const projector: readonly ClassScreen[] = [
  {
    name: 'class-projector',
    more: wall,
    async show(child, made) {
      await fills(made, 19)
      await teaches(child.page, made)
      await child.page.goto(`/teacher/projector?class=${made.id}`)
      await expect(child.page.locator('.joined b')).toHaveText('19')
    },
  },
  {
    name: 'class-projector-wifi',
    more: wall,
    async show(child, made) {
      await fills(made, 19)
      const wifi = { name: 'Botgarten', password: 'sonnenblume-26' }
      await made.teacher.ask('PUT', `/classes/${made.id}/wifi`, wifi)
      await teaches(child.page, made)
      await child.page.goto(`/teacher/projector?class=${made.id}`)
      await expect(child.page.getByText('sonnenblume-26')).toBeVisible()
    },
  },
  {
    name: 'class-wifi',
    async show(child, made) {
      await teaches(child.page, made)
      await child.page.goto(`/teacher/projector?class=${made.id}`)
      await child.presses('teacher.wifi')
      await inDialog(child)
    },
  },
  {
    name: 'class-projector-closed',
    more: wall,
    async show(child, made) {
      await made.teacher.ask('POST', `/classes/${made.id}/close`)
      await teaches(child.page, made)
      await child.page.goto(`/teacher/projector?class=${made.id}`)
      await expect(child.words('teacher.projectorClosed')).toBeVisible()
    },
  },
]

/** What a teacher sees; a phone is nobody's way to lead a class. */
export const teacherScreens: readonly ClassScreen[] = [...account, ...live, ...lists, ...projector].map(
  (screen) => ({ ...screen, neverPhone: true }),
)

/** A picture of a server that waits for its first teacher. */
export interface StartScreen {
  readonly name: string
  show(child: Child, server: EmptyServer): Promise<void>
}

/** Goes so many steps of the first start. */
async function starts(child: Child, server: EmptyServer, steps: number) {
  const { page } = child
  await page.goto(`/teacher/start#${await server.classServer.firstTeacher()}`)
  await page.getByLabel(child.word('teacher.username'), { exact: true }).fill('m.weber')
  await page.getByLabel(child.word('teacher.password'), { exact: true }).fill('kastanie im regen')
  if (steps > 0) await child.presses('teacher.makeAccount')
  if (steps > 0) await page.getByLabel(child.word('teacher.className'), { exact: true }).fill('5b')
  if (steps > 1) await child.presses('teacher.makeClass')
  if (steps > 1) await page.getByLabel(child.word('teacher.wifiName'), { exact: true }).fill('Botgarten')
  if (steps > 2) await child.presses('teacher.wifiShow')
  if (steps > 2) await expect(child.button('teacher.rehearseNow')).toBeVisible()
  if (steps > 3) await child.presses('teacher.rehearseSkip')
  if (steps > 4) await child.presses('teacher.backUpNow')
  if (steps > 4) await expect(page.getByRole('link', { name: child.word('teacher.toClass') })).toBeVisible()
}

const steps = ['account', 'class', 'wifi', 'rehearse', 'backup', 'done']

/** A rehearsal as the server tells of it. */
async function rehearses(child: Child, server: EmptyServer, events: readonly object[], isOver: boolean) {
  const body = events.map((one) => `event: progress\ndata: ${JSON.stringify(one)}\n\n`).join('')
  await starts(child, server, 3)
  await child.page.evaluate(
    ([body, isOver]) => {
      const own = globalThis.fetch
      globalThis.fetch = (address, init) => {
        if (address !== '/api/class/rehearsal') return own(address, init)
        const stream = new ReadableStream({
          start(controller) {
            controller.enqueue(new TextEncoder().encode(body))
            if (isOver) controller.close()
          },
        })
        return Promise.resolve(new Response(stream))
      }
    },
    [isOver ? body.replaceAll('progress', 'done') : body, isOver] as const,
  )
  await child.presses('teacher.rehearseNow')
}

export const startScreens: readonly StartScreen[] = [
  ...steps.map((name, at) => ({
    name: `first-start-${name}`,
    show: (child: Child, server: EmptyServer) => starts(child, server, at),
  })),
  {
    name: 'first-start',
    async show(child, server) {
      const progress = { pupils: 35, joined: 35, saves: 280, slowest: 40, seconds: 42, of: 60 }
      await rehearses(child, server, [progress], false)
      await expect(child.page.getByText('280')).toBeVisible()
    },
  },
  {
    name: 'first-start-red',
    async show(child, server) {
      const outcome = { green: false, pupils: 35, saves: 412, lost: 0, p99: 2140, slowest: 3100, rss: 180 }
      await rehearses(child, server, [outcome], true)
      await expect(child.button('teacher.rehearseAgain')).toBeVisible()
    },
  },
  {
    name: 'first-start-no-link',
    async show(child) {
      await child.page.goto('/teacher')
      await child.seesTitle()
    },
  },
]
