import { expect } from '@playwright/test'
import { content } from '@botgarten/content/files'
import { Learner } from './child-learning.ts'
import { MapMaker } from './child-maps.ts'
import type { Child } from './child.ts'
import type { Screen } from './screens.ts'

/** A drawing that breaks three rules. */
const broken = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1600 1000">
<circle id="node-0" cx="200" cy="200" r="40"/><circle id="node-1" cx="900" cy="500" r="40"/>
<path id="path-0-9" d="M200 200L900 500"/><path id="path-0-1" d="M200 200L300 500"/><path id="path-1-1" d="M900 500L920 520"/>
</svg>`

const opens = async (child: Child) => {
  await child.page.goto('/maps')
  await expect(child.button('design.new')).toBeVisible()
}

/** Begins with the map of the railway. */
async function draws(child: Child) {
  await opens(child)
  await child.page.locator('main li button').nth(1).click()
  await expect(child.page.getByRole('group', { name: child.word('design.paper'), exact: true })).toBeVisible()
}

/** Rewards that cheat: all cages, and one whose Bo was watched. */
const zoo: readonly Screen[] = [
  {
    name: 'zoo',
    async show(child) {
      await child.page.goto('/zoo')
      await expect(child.page.getByRole('heading', { level: 2 }).first()).toBeVisible()
    },
  },
  ...content.cages.map(({ cage }) => ({
    name: `zoo-cage-${cage.id}`,
    async show(child: Child) {
      await child.page.goto(`/zoo?cage=${cage.id}`)
      await child.page.locator('.guesses button').last().click()
      await child.presses('zoo.learn')
      await child.presses('zoo.pause')
    },
  })),
]

/** A map is drawn. */
const designing: readonly Screen[] = [
  { name: 'maps', show: opens },
  {
    name: 'map-upload',
    async show(child) {
      await opens(child)
      const file = { name: 'map.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(broken) }
      await child.page.locator('input[type=file]').first().setInputFiles(file)
      await expect(child.page.getByRole('alert')).toBeVisible()
    },
  },
  {
    name: 'map-empty',
    async show(child) {
      await opens(child)
      await child.presses('design.new')
      await expect(child.words('design.empty')).toBeVisible()
    },
  },
  { name: 'map-drawn', show: draws },
  {
    name: 'map-station',
    async show(child) {
      await draws(child)
      await child.button('design.station', { station: 2 }).focus()
    },
  },
  {
    name: 'map-road',
    async show(child) {
      await draws(child)
      await child.presses('design.tool.road')
      await child.page.locator('.frame [role=button]').first().focus()
    },
  },
  {
    name: 'map-list',
    async show(child) {
      await draws(child)
      await child.presses('design.asList')
    },
  },
  {
    name: 'map-dress',
    async show(child) {
      await draws(child)
      await child.presses('design.dresses.mars')
    },
  },
  {
    name: 'map-sign',
    async show(child) {
      await draws(child)
      await child.presses('design.tool.sign')
      await child.page.locator('.frame [role=button]').nth(1).focus()
      await child.types('Enter')
    },
  },
  {
    name: 'map-share',
    async show(child) {
      await draws(child)
      await child.presses('design.share')
      await expect(child.page.getByRole('dialog')).toBeVisible()
    },
  },
  {
    name: 'map-paper',
    async show(child) {
      await draws(child)
      await child.presses('design.print')
      await expect(child.page.getByRole('dialog')).toBeVisible()
    },
  },
  {
    name: 'rooms-made',
    async show(child) {
      await opens(child)
      await child.presses('rooms.new')
      const kinds = child.page.getByRole('region', { name: child.word('rooms.tools') })
      const rooms = child.page.getByRole('group', { name: child.word('rooms.field'), exact: true })
      for (const [index, kind] of (['wall', 'trap', 'ice', 'wind', 'treasure'] as const).entries()) {
        await kinds.getByRole('button', { name: child.word(`rooms.kind.${kind}`), exact: true }).click()
        await rooms
          .getByRole('button')
          .nth(index + 2)
          .click()
      }
    },
  },
  {
    name: 'map-print',
    neverPhone: true,
    async show(child) {
      await draws(child)
      await child.page.emulateMedia({ media: 'print' })
    },
  },
]

/** Chooses a map of rooms as a child does, from a card that learns by trying. */
async function chooses(child: Child, map: string) {
  const learner = new Learner(child)
  await learner.opens('mars')
  await child.presses('q.change')
  await child.page.locator('.choice select').first().selectOption(map)
  await child.types('Escape')
  return learner
}

const grids: readonly Screen[] = ['bandit', 'cliff', 'errand', 'lake', 'lake-8', 'windy'].flatMap((map) => [
  { name: `rooms-${map}`, show: async (child: Child) => void (await chooses(child, map)) },
  {
    name: `rooms-${map}-learned`,
    async show(child: Child) {
      await (await chooses(child, map)).learnsToTheEnd()
    },
  },
])

/** A room of ice, opened beside the map: where it may lead, in numbers. */
const opened: readonly Screen[] = [
  {
    name: 'rooms-lake-opened',
    neverPhone: true,
    async show(child) {
      const learner = await chooses(child, 'lake')
      await learner.givesTries(5000, 100_000, { tries: 1, time: 10_000 })
      await learner.learnsToTheEnd()
      await child.page.locator('.drawer select').selectOption('explorer')
      await child.button('q.room', { room: 8 }).click()
    },
  },
]

/** Two roads that cross, and a bend that is too tight. */
const crossing: readonly Screen[] = [
  {
    name: 'map-crossing',
    async show(child) {
      await opens(child)
      await child.presses('design.new')
      const maker = new MapMaker(child)
      const spots = await Promise.all([
        maker.place(0.15, 0.2),
        maker.place(0.85, 0.8),
        maker.place(0.15, 0.8),
        maker.place(0.85, 0.2),
      ])
      for (const { x, y } of spots) await child.page.mouse.click(x, y)
      await child.presses('design.tool.road')
      await child.drags(spots[0], spots[1])
      await child.drags(spots[2], spots[3])
      await child.drags(spots[0], spots[2])
      await child.drags(await maker.place(0.15, 0.5), await maker.place(0.3, 0.24))
    },
  },
]

export const mapScreens = [...designing, ...crossing, ...grids, ...opened, ...zoo]
