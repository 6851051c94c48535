import { expect, type Locator } from '@playwright/test'
import { BlockHands } from './child-blocks.ts'
import type { Child } from './child.ts'
import { TimeHands } from './child-time.ts'

/** How a child works the screen: with a finger alone, or with keys alone. */
export interface Way {
  press(thing: Locator): Promise<void>
  /** Sets a knob; `node` is at the end of its link. */
  turn(knob: Locator, node: Locator, weight: number): Promise<void>
  /** Chooses a block, so that the next one goes below or into it. */
  choose(block: Locator): Promise<void>
  /** Types over a number or word that stands in a block. */
  type(block: Locator, now: string, next: string): Promise<void>
  /** Another entry of a list that opens in a block. */
  pick(block: Locator, now: string, next: string): Promise<void>
  /** Takes a hit of the search for blocks. */
  take(hit: Locator): Promise<void>
  hurry(): Promise<void>
}

type Kind = 'Input' | 'Dropdown'

/** A field of a block, by what stands in it. */
const fieldIn = (block: Locator, kind: Kind, text: string) =>
  block
    .locator(`.blockly${kind}Field`)
    .filter({ hasText: new RegExp(`^\\s*${text}\\s*$`) })
    .first()

const typesOver = async ({ page }: Child, next: string) => {
  const field = page.locator('.blocklyHtmlInput')
  await expect(field).toBeFocused()
  await page.keyboard.press('ControlOrMeta+a')
  await page.keyboard.type(next)
  await page.keyboard.press('Enter')
  await expect(field).toHaveCount(0)
}

/** A corner of a block where none of its fields is. */
const corner = { position: { x: 12, y: 12 } }

export const byFinger = (child: Child): Way => ({
  press: (thing) => thing.tap(),
  turn: (knob, node, weight) => child.dragsAlong(knob, node, weight),
  choose: (block) => block.tap(corner),
  async type(block, now, next) {
    await fieldIn(block, 'Input', now).tap()
    await typesOver(child, next)
  },
  async pick(block, now, next) {
    await fieldIn(block, 'Dropdown', now).tap()
    await child.page.getByRole('option', { name: next, exact: true }).tap()
  },
  take: (hit) => hit.tap(),
  hurry: () => new TimeHands(child).hurries(),
})

const focused = (thing: Locator) => thing.evaluate((one) => one === document.activeElement)

/** Of a group that has one stop of the Tab key, the arrows reach all. */
async function goesRound(child: Child, thing: Locator) {
  await child.tabsTo(thing.locator('xpath=..').locator('> [tabindex="0"]'))
  for (let presses = 0; presses < 90 && !(await focused(thing)); presses += 1) await child.types('ArrowRight')
}

export const byKeys = (child: Child): Way => {
  const blocks = new BlockHands(child)
  const goesTo = async (block: Locator) => {
    await expect(block).toHaveCount(1)
    await blocks.goesTo((await block.getAttribute('data-id'))!)
  }
  /** The arrows go from field to field of a block, and through what stands in it. */
  const goesToField = async (block: Locator, kind: Kind, now: string) => {
    const here = fieldIn(block, kind, now)
    await goesTo(block)
    for (let presses = 0; presses < 12 && !(await focused(here)); presses += 1)
      await child.types('ArrowRight')
    await expect(here).toBeFocused()
  }
  return {
    async press(thing) {
      if ((await thing.getAttribute('tabindex')) === '-1') await goesRound(child, thing)
      else await child.tabsTo(thing)
      await child.types('Enter')
    },
    async turn(knob, _, weight) {
      await child.tabsTo(knob)
      await child.types(...weight.toLocaleString(child.language), 'Enter')
      await expect(knob).toHaveAttribute('aria-valuenow', String(weight))
    },
    choose: goesTo,
    async type(block, now, next) {
      await goesToField(block, 'Input', now)
      await child.types('Enter')
      await typesOver(child, next)
    },
    async pick(block, now, next) {
      await goesToField(block, 'Dropdown', now)
      await child.types('Enter')
      const option = child.page.getByRole('option', { name: next, exact: true })
      await expect(option).toBeVisible()
      const there = () =>
        option.evaluate(
          (one) => one === document.activeElement || one.classList.contains('blocklyMenuItemHighlight'),
        )
      for (let presses = 0; presses < 12 && !(await there()); presses += 1) await child.types('ArrowDown')
      await child.types('Enter')
      await expect(option).toHaveCount(0)
    },
    async take(hit) {
      for (
        let presses = 0;
        presses < 12 && (await hit.getAttribute('aria-selected')) !== 'true';
        presses += 1
      )
        await child.types('ArrowDown')
      await child.types('Enter')
    },
    hurry: () => new TimeHands(child).hurriesByKeys(),
  }
}

/** Finds a block by a word and puts it in at the one that was chosen last. Returns it. */
export async function finds(child: Child, way: Way, query: string, type: string): Promise<Locator> {
  const blocks = new BlockHands(child)
  const all = child.canvas.locator(`.${type}`)
  const ids = () => all.evaluateAll((blocks) => blocks.map((block) => block.getAttribute('data-id')!))
  const before = await ids()
  await way.press(child.button('editor.search'))
  await blocks.field.pressSequentially(query)
  await expect(blocks.hits.first()).toBeVisible()
  await way.take(blocks.hits.first())
  await expect(blocks.field).toHaveCount(0)
  await expect(all).toHaveCount(before.length + 1)
  return child.block((await ids()).find((id) => !before.includes(id))!)
}
