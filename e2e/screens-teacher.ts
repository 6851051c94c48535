import { expect, type Page } from '@playwright/test'
import { isAnswered, opensForm, sends } from './asked-class.ts'
import type { Child } from './child.ts'
import { Asker, setClock } from './class-server.ts'
import { fills, teaches, type MadeClass } from './made-class.ts'
import type { ClassScreen } from './screens-class.ts'
import { projector } from './screens-projector.ts'

type View = 'live' | 'cards' | 'gallery' | 'questionnaires' | 'class' | 'data'

export const opensView = async (child: Child, made: MadeClass, view: View) => {
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
      await expect(child.page.getByText('Zebra', { exact: true })).toBeVisible()
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
    name: 'class-questionnaires',
    async show(child, made) {
      await isAnswered(made, 'before', 22)
      await opensForm(made, 'after')
      for (let n = 0; n < 12; n += 1) await sends(made, 'after', n)
      await opensView(child, made, 'questionnaires')
      await expect(child.words('form.class.open')).toBeVisible()
    },
  },
  {
    name: 'class-results',
    async show(child, made) {
      for (const form of ['before', 'after']) await isAnswered(made, form, 22)
      await opensView(child, made, 'questionnaires')
      await child.page
        .getByRole('button', { name: child.word('form.results'), exact: true })
        .nth(1)
        .click()
      await expect(child.words('form.answers', { count: 22 }).first()).toBeVisible()
    },
  },
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

/** One more teacher, with a class. */
async function invites({ teacher, url, classServer }: MadeClass) {
  const { token } = (await teacher.ask('POST', '/invitations')).body as { token: string }
  const other = new Asker(url)
  const made = { token, username: 'k.otto', password: 'kastanie im regen' }
  await other.ask('POST', '/teachers', made)
  const about = { name: '7c', language: 'de', grade: 7, endsOn: classServer.ports.day(120) }
  await other.ask('POST', '/classes', about)
}

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
    name: 'teacher-health',
    async show(child, made) {
      await teaches(child.page, made)
      await child.page.goto('/teacher/health')
      await expect(child.page.getByText(child.word('teacher.about.backup'), { exact: true })).toBeVisible()
    },
  },
  {
    name: 'teacher-clock',
    async show(child, made) {
      setClock(made)(300)
      await teaches(child.page, made)
      await child.page.goto('/teacher/health')
      await expect(child.words('teacher.clockDoubt.title')).toBeVisible()
    },
  },
  {
    name: 'teacher-account',
    async show(child, made) {
      await invites(made)
      await teaches(child.page, made)
      await child.page.goto('/teacher/account')
      await expect(child.words('teacher.refused.onlyOperator')).toBeVisible()
    },
  },
  {
    name: 'teacher-account-delete',
    async show(child, made) {
      await invites(made)
      await teaches(child.page, made)
      await child.page.goto('/teacher/account')
      await child.presses('teacher.account.deleteOne', { name: 'k.otto' })
      await inDialog(child)
    },
  },
  {
    name: 'teacher-backup-phrase',
    async show(child, made) {
      await made.teacher.ask('POST', '/backup/phrase', { password: null })
      await teaches(child.page, made)
      await child.page.goto('/teacher/health')
      await child.presses('teacher.phrase.show')
      await expect(child.words('teacher.phrase.askPassword')).toBeVisible()
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

/** What a teacher sees; a phone is nobody's way to lead a class. */
export const teacherScreens: readonly ClassScreen[] = [...account, ...live, ...lists, ...projector].map(
  (screen) => ({ ...screen, neverPhone: true }),
)
