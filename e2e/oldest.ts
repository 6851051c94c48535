// Chromium as the oldest promised browsers see a page: without each API that one of them lacks, by MDN's table.
import type { BrowserContext } from '@playwright/test'
import { promised } from '../packages/browsers/promised.ts'
import { lackedIn } from '../scripts/browsers/support.mjs'

type Lacked = ReturnType<typeof lackedIn>

/** Deletes APIs where the page runs. Members of prototypes in MDN's list of JavaScript may be static ones. */
function withoutThem(lacked: Lacked): void {
  const page = globalThis as unknown as { [name: string]: { prototype?: object } | undefined }
  for (const [owner, name, isStatic] of lacked) {
    if (owner === '') Reflect.deleteProperty(page, name)
    const own = owner === '' ? undefined : page[owner]
    if (!own) continue
    Reflect.deleteProperty(own, name)
    if (!isStatic && own.prototype) Reflect.deleteProperty(own.prototype, name)
  }
}

/** Playwright calls these where the page runs; `npm run check:browsers` refuses them in our own scripts. */
const ofPlaywright = ['Element.checkVisibility']

const all = lackedIn(promised).filter(([owner, name]) => !ofPlaywright.includes(`${owner}.${name}`))

/** Every page of a context gets the APIs of the oldest promised browsers. Workers have those of Chromium. */
export const becomesOldest = (context: BrowserContext): Promise<unknown> =>
  context.addInitScript(withoutThem, all)
