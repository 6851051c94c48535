import { expect, type Page } from '@playwright/test'
import { opensForm } from './asked-class.ts'
import { leftEye, leftWheel, type Child } from './child.ts'
import { Pupil } from './child-class.ts'
import { setClock } from './class-server.ts'
import { joins, saves, signsIn, type Joined, type MadeClass } from './made-class.ts'
import { galleryScreens } from './screens-gallery.ts'
import { joining } from './screens-joining.ts'
import { togetherScreens } from './screens-together.ts'

/** One picture of a class: how somebody gets there. */
export interface ClassScreen {
  readonly name: string
  readonly neverPhone?: boolean
  /** Sizes beside the usual ones. */
  readonly more?: readonly { readonly width: number; readonly height: number }[]
  show(child: Child, made: MadeClass): Promise<void>
}

/** A page of a class that cannot be reached. */
const pullsCable = (page: Page) => page.route('**/api/class/**', (route) => route.abort())

/** A pupil's lab with work that is in the class. */
async function opensLab(child: Child, made: MadeClass) {
  const pupil = await joins(made, 'Kestrel')
  await saves(pupil)
  await signsIn(child.page, made, pupil)
  await child.opensLab('friendship')
  return pupil
}

const chip = (child: Child, key: string) =>
  child.page.getByRole('button', { name: child.word(key), exact: true })

async function changes(child: Child, weight: number) {
  if (child.page.viewportSize()!.width < 640) await child.turnsTo('networkTab')
  await child.typesWeight(leftEye, leftWheel, weight)
}

async function disagrees(child: Child, made: MadeClass) {
  const pupil = await opensLab(child, made)
  await saves(pupil, { base: 1, starts: [0, 1], program: 'start' })
  await changes(child, 0.5)
  await expect(child.page.getByRole('dialog')).toBeVisible()
  await expect(child.page.getByRole('heading', { level: 2 }).nth(1)).toBeVisible()
}

const gate: readonly ClassScreen[] = [
  {
    name: 'class-asked',
    async show(child, made) {
      await opensForm(made, 'after')
      await signsIn(child.page, made, await joins(made, 'Kiwi'))
      await child.page.goto('/')
      await expect(child.words('class.askedTitle')).toBeVisible()
    },
  },
  {
    name: 'class-question-code',
    async show(child, made) {
      await opensForm(made, 'after')
      await signsIn(child.page, made, await joins(made, 'Kiwi'))
      await child.page.goto('/questionnaires/class')
      await expect(child.words('form.codeTitle')).toBeVisible()
    },
  },
  ...(['asks', 'back'] as const).map((as): ClassScreen => ({
    name: as === 'asks' ? 'are-you' : 'welcome-back',
    async show(child, made) {
      const pupil = await joins(made, 'Fuchs')
      await saves(pupil)
      await signsIn(child.page, made, pupil, as)
      await child.page.goto('/')
      await expect(child.page.getByRole('dialog')).toBeVisible()
      if (as === 'back') await expect(child.words('class.workIsHere')).toBeVisible()
    },
  })),
  {
    name: 'are-you-quiet',
    async show(child, made) {
      await child.page.clock.install()
      await signsIn(child.page, made, await joins(made, 'Fuchs'))
      await child.opensHome()
      await child.page.clock.fastForward('11:00')
      await expect(child.page.getByRole('dialog')).toBeVisible()
    },
  },
  {
    name: 'are-you-pictures',
    async show(child, made) {
      await child.page.route('**/api/class/me', async (route) => {
        const answer = await route.fetch()
        await route.fulfill({ json: { ...((await answer.json()) as object), fresh: false } })
      })
      await signsIn(child.page, made, await joins(made, 'Fuchs'), 'asks')
      await child.page.goto('/')
      await child.presses('class.yesOn')
      await expect(child.words('class.whichPictures')).toBeVisible()
    },
  },
  {
    name: 'locked',
    async show(child, made) {
      await signsIn(child.page, made, await joins(made, 'Fuchs'), 'asks')
      await pullsCable(child.page)
      await child.page.goto('/')
      await child.presses('class.yesOn')
      await expect(child.words('class.lockedText')).toBeVisible()
    },
  },
  {
    name: 'signed-out',
    async show(child, made) {
      const pupil = await joins(made, 'Fuchs')
      await signsIn(child.page, made, pupil)
      await made.teacher.ask('POST', `/classes/${made.id}/sign-out-all`)
      await child.page.goto('/')
      await expect(child.words('class.signedOut')).toBeVisible()
    },
  },
  {
    name: 'class-ended',
    async show(child, made) {
      await signsIn(child.page, made, await joins(made, 'Fuchs'))
      await made.teacher.ask('DELETE', `/classes/${made.id}`, { name: '5b' })
      await child.page.goto('/')
      await expect(child.words('class.ended')).toBeVisible()
    },
  },
  {
    name: 'class-hidden',
    async show(child, made) {
      await signsIn(child.page, made, await joins(made, 'Fuchs'))
      setClock(made)(300)
      await child.page.goto('/')
      await expect(child.words('class.hidden')).toBeVisible()
    },
  },
]

/** The teacher looks inside, and sends a hint and a program. */
async function teacherSends({ id, teacher }: MadeClass, pupil: Joined) {
  await teacher.ask('POST', `/classes/${id}/handouts`, {
    ...{ to: [pupil.id], kind: 'hint', card: 'friendship', hint: 1 },
  })
  await teacher.ask('POST', `/classes/${id}/handouts`, { to: 'all', kind: 'program', card: 'fear' })
  await teacher.ask('POST', `/classes/${id}/pupils/${pupil.id}/inside`)
}

const inTheLab: readonly ClassScreen[] = [
  {
    name: 'class-chip',
    async show(child, made) {
      await opensLab(child, made)
      await expect(chip(child, 'class.chipClass')).toBeVisible()
    },
  },
  {
    name: 'class-chip-why',
    async show(child, made) {
      await opensLab(child, made)
      await pullsCable(child.page)
      await changes(child, 0.3)
      await chip(child, 'class.chipHere').click()
      await expect(child.page.getByRole('dialog')).toBeVisible()
    },
  },
  {
    name: 'person-menu',
    async show(child, made) {
      await opensLab(child, made)
      await new Pupil(child, made).opensMenu()
    },
  },
  {
    name: 'hand-up',
    async show(child, made) {
      await opensLab(child, made)
      await new Pupil(child, made).opensMenu()
      await child.presses('class.raiseHand')
      await expect(child.button('class.raiseHand')).toHaveCount(0)
    },
  },
  {
    name: 'class-leave',
    async show(child, made) {
      await opensLab(child, made)
      await new Pupil(child, made).opensMenu()
      await child.presses('class.leave')
      await expect(child.page.getByRole('dialog')).toBeVisible()
    },
  },
  {
    name: 'class-versions',
    async show(child, made) {
      const pupil = await opensLab(child, made)
      await saves(pupil, { base: 1, starts: [0, 1] })
      await child.reloads()
      await new Pupil(child, made).opensMenu()
      await child.presses('class.versions')
      await expect(child.button('class.takeVersion')).toBeVisible()
    },
  },
  { name: 'two-devices', show: disagrees },
  ...(['from-teacher', 'from-teacher-folded', 'from-teacher-home'] as const).map((name): ClassScreen => ({
    name,
    async show(child, made) {
      const pupil = await opensLab(child, made)
      if (name.endsWith('home')) await child.opensHome()
      await teacherSends(made, pupil)
      await expect(child.words('class.looksInBy', { name: 'm.weber' })).toBeVisible()
      await expect(child.button('class.openOffer')).toBeVisible()
      if (!name.endsWith('folded')) return
      for (const title of ['class.hintFor', 'class.offer'])
        await child.page
          .getByRole('button', {
            name: child.word(title, { card: child.card('friendship'), name: child.card('fear') }),
          })
          .click()
    },
  })),
  {
    name: 'attention',
    async show(child, made) {
      await opensLab(child, made)
      await child.presses('lab.start')
      await made.teacher.ask('PUT', `/classes/${made.id}/attention`, { on: true })
      await expect(child.words('class.attentionTitle')).toBeVisible()
    },
  },
  ...(['closed-card', 'free-today'] as const).map((name): ClassScreen => ({
    name,
    async show(child, made) {
      await made.teacher.ask('PUT', `/classes/${made.id}/free`, {
        cards: ['fear', 'way-home'],
        level: 'plain',
      })
      if (name === 'closed-card') {
        await opensLab(child, made)
        await expect(child.words('class.closedTitle')).toBeVisible()
      } else {
        await signsIn(child.page, made, await joins(made, 'Fuchs'))
        await child.opensHome()
        await expect(child.page.getByRole('img', { name: child.word('home.closed') }).first()).toBeVisible()
      }
    },
  })),
  {
    name: 'class-home',
    async show(child, made) {
      await signsIn(child.page, made, await joins(made, 'Fuchs'))
      await child.opensHome()
      await expect(child.page.locator('.person')).toBeVisible()
    },
  },
]

/** What a pupil sees. */
export const pupilScreens: readonly ClassScreen[] = [
  ...joining,
  ...gate,
  ...inTheLab,
  ...galleryScreens,
  ...togetherScreens,
]
