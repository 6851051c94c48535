// Rooms: network, editor, q-learning, world
import { content } from '@botgarten/content/files'
import type { Child } from '../child.ts'
import { isLong } from '../beds.ts'
import { expect, test } from '../house.ts'

/** Sequences of clicks; `npm run test:long` has 300, each on the next card. */
const sequences = isLong ? 300 : 10
/** Clicks of one sequence. */
const clicks = 8

/** Numbers from a seed: 0 to below `count`. */
function pickerOf(seed: number) {
  let state = seed
  return (count: number) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    return Math.floor((state / 2 ** 32) * count)
  }
}

/** Buttons, tabs, switches and knobs of the lab that can be reached now. */
const controls =
  'main :is(button, [role=tab], [role=slider], input[type=checkbox], input[type=radio], select)'

/** Uses one control of the lab, whichever it is. */
async function usesOne(child: Child, below: (count: number) => number) {
  const { page } = child
  const all = page.locator(controls).filter({ visible: true })
  const one = all.nth(below(await all.count()))
  const role = await one.evaluate((element) => element.getAttribute('role') ?? element.localName)
  if (role === 'slider') {
    await one.focus()
    await page.keyboard.press(['ArrowUp', 'ArrowDown', 'Home', 'End'][below(4)]!)
  } else if (role === 'select') await one.selectOption({ index: below(2) })
  // Another control may cover it, and a press may be the last of a button that goes.
  else await one.click({ timeout: 1_000, trial: false }).catch(() => undefined)
}

/** Programs, weights and world of the project, as the device has them. */
const savedIn = (child: Child) =>
  child.page.evaluate(
    () =>
      new Promise<unknown>((done, fail) => {
        const opening = indexedDB.open('botgarten')
        opening.onerror = () => fail(opening.error!)
        opening.onsuccess = () => {
          const reading = opening.result.transaction('projects').objectStore('projects').getAll()
          reading.onsuccess = () => {
            opening.result.close()
            const all = reading.result as {
              project: { programs: unknown; brains: unknown; world: unknown }
            }[]
            done(all.map(({ project: { programs, brains, world } }) => ({ programs, brains, world })))
          }
        }
      }),
  )

/** Weights as the lab displays them. */
const weightsIn = (child: Child) =>
  child.page
    .locator('main [role=slider][aria-valuetext]')
    .evaluateAll((all) => all.map((one) => one.getAttribute('aria-valuetext')))

for (let sequence = 0; sequence < sequences; sequence++) {
  const { id } = content.cards[(sequence * 7) % content.cards.length]!

  test(`sequence ${sequence}: random clicks while ${id} runs; the work is there after a reload`, async ({
    child,
  }) => {
    const below = pickerOf(sequence + 1)
    await child.opensLab(id)
    const address = child.page.url()
    await child.pressesStart()
    for (let click = 0; click < clicks; click++) {
      await usesOne(child, below)
      await child.page.keyboard.press('Escape')
      if (new URL(child.page.url()).pathname !== new URL(address).pathname) {
        await child.page.goBack()
        await child.seesLab()
      }
    }
    await child.seesSaved()
    const saved = await savedIn(child)
    await child.reloads()
    await expect.poll(() => savedIn(child)).toEqual(saved)
    const weights = await weightsIn(child)
    await child.reloads()
    await expect.poll(() => weightsIn(child)).toEqual(weights)
  })
}
