import type { Block } from '@botgarten/blocks'
import type { CardProgram } from '@botgarten/content'
import { expect, type Locator } from '@playwright/test'
import { BlockHands } from './child-blocks.ts'
import { chooses } from './child-cards.ts'
import type { Child } from './child.ts'

interface Task {
  readonly start: CardProgram
  readonly solution: CardProgram
}

/** Blocks of a program in its stacks, in their order. */
const blocksOf = ({ programs }: CardProgram): readonly Block[] =>
  Object.values(programs).flatMap(({ stacks }) => stacks.flatMap(({ blocks }) => blocks))

const ofType = (program: CardProgram, type: string) =>
  blocksOf(program).filter((block) => block.type === type)

/** Does Bo learn by trying with its own sensors on a card? */
export const isTried = ({ solution }: Task): boolean => ofType(solution, 'ai_try_learn').length > 0

/** Solves a card as its hints say: what pays otherwise is chosen in its block, what is missing comes out of the toolbox. */
export async function pays(child: Child, { start, solution }: Task) {
  const given = ofType(start, 'ai_try_pay')
  const [learn] = ofType(start, 'ai_try_learn')
  const wanted = ofType(solution, 'ai_try_pay')
  if (given.length > 0) {
    // First it shows what it was paid for. It stays where it was stopped: only a start place counts.
    await child.pressesStart()
    await child.seesDriving()
    await child.pressesStop()
    await child.presses('lab.place', { number: 1 })
  }
  for (const [at, { fields }] of wanted.entries()) {
    const before = given[at]
    if (!before) await pulls(child, wordOf(fields!['WHAT']!), child.block(learn!.id))
    else if (before.fields!['WHAT'] !== fields!['WHAT'])
      await chooses(child, child.block(before.id), wordOf(before.fields!['WHAT']!), wordOf(fields!['WHAT']!))
  }
  const said = (blocks: readonly Block[]) => blocks.map(({ fields }) => fields)
  expect(said(await new BlockHands(child).inFile('ai_try_pay'))).toEqual(said(wanted))
}

/** `BUMP` → `payBump`, as the choice is called in the messages. */
const wordOf = (what: string) => `pay${what[0]}${what.slice(1).toLowerCase()}`

/** Takes the block that pays for something out of the toolbox, and drops it above another one. */
async function pulls(child: Child, what: string, above: Locator) {
  const { page } = child
  await child.press(new BlockHands(child).row('q-learning'))
  const blocks = page.locator('.blocklyFlyout .ai_try_pay')
  const block = blocks.filter({ hasText: child.word(`choice.${what}`) }).first()
  await expect(block).toBeAttached()
  const shelf = (await page.locator('.blocklyFlyout').last().boundingBox())!
  await page.mouse.move(shelf.x + 40, shelf.y + shelf.height / 2)
  const bottom = shelf.y + shelf.height - 10
  for (let turns = 0; turns < 40 && (await endOf(block)) > bottom; turns += 1) {
    await page.mouse.wheel(0, 60)
    await child.watches(2)
  }
  const [from, to] = [(await block.boundingBox())!, (await above.boundingBox())!]
  await child.drags({ x: from.x + 8, y: from.y + 12 }, { x: to.x + 8, y: to.y + 12 })
  await expect(page.locator('.blocklyDragging')).toHaveCount(0)
}

async function endOf(block: Locator): Promise<number> {
  const { y, height } = (await block.boundingBox())!
  return y + height
}
