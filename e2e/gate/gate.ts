// Shared by the tests of the gate: one server a worker, which has a teacher, and navigation by clicks from home.
import type { Locator, Page } from '@playwright/test'
import type { Child } from '../child.ts'
import { classOfTest } from '../class-server.ts'
import { lendClass } from '../class-test.ts'
import { expect, test as base } from '../house.ts'
import type { MadeClass } from '../made-class.ts'

export { expect }

/** Every test of the gate has this server, so that a worker never starts another one. `school`: an open class of its own. */
export const test = base.extend<{ school: MadeClass }, { room: MadeClass }>({
  room: [
    // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of the fixtures
    async ({}, use) => {
      const room = await classOfTest()
      await use(room)
      await room.close()
    },
    { scope: 'worker' },
  ],
  house: [({ room }, use) => use(room.url), { scope: 'worker' }],
  school: ({ room, language }, use) => lendClass(room, language, use),
})

/** From home to a card of the lab. */
export async function opensCard(child: Child, card: string) {
  await child.opensHome()
  await (await child.findsCard(card)).click()
  await child.seesLab()
}

/** From home to a project that a child has as a file. */
export async function opensProject(child: Child, name: string, text: string) {
  await child.opensHome()
  await child.opensFileAtHome(`${name}.botgarten.json`, text)
  await expect(child.page.getByRole('heading', { level: 1 })).toHaveText(name)
  await child.seesLab()
}

/** A link by the message that it shows. */
export const link = (child: Child, key: string): Locator =>
  child.page.getByRole('link', { name: child.word(key), exact: true }).first()

/** From home to a page that it leads to. */
export async function follows(child: Child, key: string) {
  await child.opensHome()
  await link(child, key).click()
}

/** The title of a page. */
export const title = (page: Page): Locator => page.getByRole('heading', { level: 1 })

/** A position and heading of Bo on its floor, in cm and degrees. */
export async function poseOf(child: Child): Promise<{ x: number; y: number; heading: number }> {
  const [x, y, heading] = (await child.boStands()).split(',').map(Number)
  return { x: x!, y: y!, heading: heading! }
}
