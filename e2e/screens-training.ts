import { expect } from '@playwright/test'
import { Teaching } from './child-training.ts'
import type { Child } from './child.ts'
import type { Screen } from './screens.ts'

type Level = 'starter' | 'explorer' | 'expert'

/** Six examples, the last two of them against each other. */
const rows = `eyeLeft,eyeRight,wheelLeft,wheelRight
40,40,45,45
39,59,25,60
68,100,50,90
100,53,65,25
29,28,25,25
30,28,90,-40
`

async function teaches(child: Child, phone: boolean, level: Level = 'starter') {
  await child.page.addInitScript(
    (name) => localStorage.setItem('botgarten.network-level', JSON.stringify(name)),
    level,
  )
  await child.opensLab('friendship')
  if (phone) await child.turnsTo('networkTab')
  const teaching = new Teaching(child)
  await teaching.shows()
  return teaching
}

async function hasExamples(child: Child, phone: boolean, level?: Level) {
  const teaching = await teaches(child, phone, level)
  await teaching.opensFile('rows.csv', rows)
  await teaching.seesExamples(6)
  return teaching
}

async function practises(child: Child, phone: boolean, level?: Level) {
  const teaching = await hasExamples(child, phone, level)
  await teaching.letsPractise()
  return teaching
}

/** How examples are shown, in every state of the table. */
const showing: readonly Screen[] = [
  { name: 'show-empty', show: async (child, phone) => void (await teaches(child, phone)) },
  {
    name: 'show-remember',
    async show(child, phone) {
      const teaching = await teaches(child, phone)
      for (const [left, right] of [
        [45, 45],
        [25, 60],
        [90, 50],
      ] as const)
        await teaching.remembers(left, right)
      await teaching.seesExamples(3)
    },
  },
  { name: 'show-question', show: async (child, phone) => void (await hasExamples(child, phone)) },
  {
    name: 'show-row',
    async show(child, phone) {
      await hasExamples(child, phone, 'explorer')
      await child.page.locator('.show tbody .number button').first().click()
    },
  },
  {
    name: 'show-field',
    async show(child, phone) {
      await hasExamples(child, phone)
      await child.presses('training.fieldView')
    },
  },
  {
    name: 'show-drawer',
    async show(child, phone) {
      const teaching = await hasExamples(child, phone)
      await teaching.setsAside(2)
      await child.presses('training.aside', { count: 1 })
    },
  },
  {
    name: 'show-columns',
    async show(child, phone) {
      const teaching = await hasExamples(child, phone)
      await teaching.opensFile('other.csv', 'a;b;c;d\n1,5;2;3;4\n')
      await expect(child.page.getByRole('dialog')).toBeVisible()
    },
  },
  {
    name: 'show-refused',
    async show(child, phone) {
      const teaching = await hasExamples(child, phone)
      await teaching.opensFile('broken.csv', 'eyeLeft,eyeRight,wheelLeft,wheelRight\n1,2,x,4\n')
      const facts = { row: 2, column: 3, cell: 'x' }
      await expect(child.words('training.file.table.noNumber', facts)).toBeVisible()
    },
  },
  {
    name: 'show-drive',
    async show(child, phone) {
      const teaching = await teaches(child, phone)
      await teaching.chooses('drive')
      await teaching.drivesUntil(() => expect.poll(() => teaching.count()).toBeGreaterThan(9))
    },
  },
  ...(['coach', 'copy'] as const).map((mode) => ({
    name: `show-${mode}`,
    async show(child: Child, phone: boolean) {
      const teaching = await hasExamples(child, phone, 'explorer')
      await teaching.chooses(mode)
    },
  })),
]

/** How examples are practised. */
const practising: readonly Screen[] = [
  { name: 'practise-rest', show: async (child, phone) => void (await practises(child, phone)) },
  ...(['explorer', 'expert'] as const).map((level) => ({
    name: `practise-${level}`,
    async show(child: Child, phone: boolean) {
      const teaching = await practises(child, phone, level)
      await teaching.practises()
      await child.presses('training.more')
    },
  })),
  {
    name: 'practise-going',
    async show(child, phone) {
      await practises(child, phone)
      const pace = child.word('training.pace')
      await child.page.getByRole('combobox', { name: pace }).selectOption({ index: 0 })
      await child.presses('training.practise')
      await expect(child.button('training.pause').first()).toBeVisible()
    },
  },
  {
    name: 'practise-done',
    async show(child, phone) {
      await (await practises(child, phone)).practises()
    },
  },
  ...(['sums', 'error', 'arrows', 'knobs'] as const).map((last) => ({
    name: `practise-${last}`,
    async show(child: Child, phone: boolean) {
      await practises(child, phone)
      await child.presses('training.oneExample')
      for (const beat of ['inputs', 'sums', 'says', 'error', 'arrows', 'knobs'] as const) {
        await child.presses(`training.next.${beat}`)
        if (beat === last) break
      }
      if (last === 'arrows') await child.page.locator('.net button[aria-label*="?"]').first().click()
    },
  })),
  {
    name: 'practise-alone',
    async show(child, phone) {
      await (await practises(child, phone)).practises()
      await child.presses('training.alone')
      await child.presses('training.aloneGo')
      await expect(child.page.getByText(/^\S+ 60: \d \S+ 4$/)).toBeVisible()
    },
  },
]

export const trainingScreens = [...showing, ...practising]
