import { expect, type Locator } from '@playwright/test'
import { tableOf } from '@botgarten/messages/folder'
import type { Block } from '@botgarten/blocks'
import type { Project } from '@botgarten/programs'
import type { Child } from './child.ts'
import type { Spot } from './hand.ts'
import { languages } from './words.ts'

type Item = 'COPY_SHORTCUT' | 'PASTE_SHORTCUT' | 'DUPLICATE_BLOCK' | 'ADD_COMMENT' | 'REMOVE_COMMENT'
type Switch = 'COLLAPSE_BLOCK' | 'EXPAND_BLOCK' | 'DISABLE_BLOCK' | 'ENABLE_BLOCK'

/** Blockly's own words, as the menus say them. */
const blockly = new Map(
  languages.map((language) => [
    language,
    tableOf('blockly', language) as { readonly [key in Item | Switch]: string },
  ]),
)

/** Hands for the whole block language: the shelf, the search and the menus. */
export class BlockHands {
  readonly #child: Child

  constructor(child: Child) {
    this.#child = child
  }

  get #page() {
    return this.#child.page
  }

  get all(): Locator {
    return this.#page.getByRole('switch', { name: this.#child.word('editor.all') })
  }
  get field(): Locator {
    return this.#page.getByRole('combobox', { name: this.#child.word('shelf.field') })
  }
  get hits(): Locator {
    return this.#page.getByRole('listbox', { name: this.#child.word('shelf.list') }).getByRole('option')
  }
  row(category: string): Locator {
    const name = this.#child.word(`category.${category}`)
    return this.#page.getByRole('treeitem', { name, exact: true })
  }

  async searches(words: string) {
    await this.#child.presses('editor.search')
    await this.field.fill(words)
  }

  /** Pulls a block that was found to a spot of the paper. */
  async pulls(hit: Locator, to: Spot) {
    const { x, y } = (await hit.boundingBox())!
    await this.#page.mouse.move(x + 60, y + 20)
    await this.#page.mouse.down()
    await this.#page.mouse.move(x + 80, y + 40, { steps: 3 })
    await expect(this.field).toHaveCount(0)
    await this.#page.mouse.move(to.x, to.y, { steps: 6 })
    await this.#page.mouse.up()
    await expect(this.#page.locator('.blocklyDragging')).toHaveCount(0)
  }

  /** What Blockly calls an item of its menus, in the child's language. */
  item(name: Item | Switch): Locator {
    const words = blockly.get(this.#child.language)![name]
    return this.#page.getByRole('menuitem', { name: words })
  }

  /** A corner of a block where none of its fields is. */
  readonly corner = { position: { x: 12, y: 12 } }

  async chooses(block: string, name: Item | Switch) {
    await this.#child.block(block).click({ ...this.corner, button: 'right' })
    await this.#child.press(this.item(name))
    await expect(this.#page.locator('.blocklyContextMenu')).toHaveCount(0)
    await this.#isCarriedOut()
  }

  /** Blockly does what was chosen after the next frame, when its menu is gone already. */
  #isCarriedOut() {
    return this.#page.evaluate(
      () => new Promise<void>((done) => requestAnimationFrame(() => setTimeout(done, 0))),
    )
  }

  /** The same by the keyboard alone: the block has the focus. */
  async choosesByKeys(name: Item | Switch) {
    // A page that is busy has not given the focus back yet, and opens its menu later.
    await expect(this.#page.locator('.blocklyPath.blocklyActiveFocus')).toHaveCount(1)
    await this.#page.keyboard.press('Control+Enter')
    const words = blockly.get(this.#child.language)![name]
    await expect(this.#page.getByRole('menu')).toBeFocused()
    await expect(this.item(name)).toBeVisible()
    const items = await this.#page.getByRole('menuitem').allTextContents()
    const at = items.findIndex((item) => item.startsWith(words))
    expect(at, `${words} in ${items.join(', ')}`).toBeGreaterThanOrEqual(0)
    for (let presses = 0; presses < at; presses += 1) await this.#page.keyboard.press('ArrowDown')
    await this.#page.keyboard.press('Enter')
    await expect(this.#page.getByRole('menuitem')).toHaveCount(0)
    await this.#isCarriedOut()
  }

  /** Writes into the note that has just opened. */
  async writes(words: string) {
    await expect(this.#page.locator('.blocklyCommentText')).toBeFocused()
    await this.#page.keyboard.type(words)
  }

  /** Goes to a block by the keyboard alone. */
  async goesTo(block: string) {
    const at = () =>
      this.#page.evaluate(() => {
        const here = document.activeElement
        const isPaper = here?.closest('.blocklySvg') != null
        // A number is its field and nothing else.
        const isBlock = here?.matches('.blocklyPath, .math_number > *') ?? false
        return { isPaper, isBlock, block: here?.closest('[data-id]')?.getAttribute('data-id') ?? null }
      })
    // While parts of the page still load, Tab does not reach the blocks: a child begins again.
    await expect(async () => {
      for (let presses = 0; presses < 60 && !(await at()).isPaper; presses += 1)
        await this.#page.keyboard.press('Tab')
      await this.#page.keyboard.press('Control+Home')
      for (let presses = 0; presses < 30 && (await at()).block !== block; presses += 1)
        await this.#page.keyboard.press('ArrowDown')
      // What stands in the block comes before the next one.
      for (let presses = 0; presses < 5 && !(await at()).isBlock; presses += 1)
        await this.#page.keyboard.press('ArrowLeft')
      await expect.poll(at).toEqual({ isPaper: true, isBlock: true, block })
    }).toPass()
  }

  /** Brings a block to the gap of a parent where another one sits: it goes in there, if it fits. */
  async joins(by: 'hand' | 'keys', block: string, sits: string) {
    await expect(this.#child.block(block)).toBeVisible()
    if (by === 'keys') return this.#joinsByKeys(block, sits)
    const { x, y } = (await this.#child.block(block).boundingBox())!
    const to = (await this.#child.block(sits).boundingBox())!
    await this.#child.drags({ x: x + 5, y: y + 15 }, { x: to.x + 8, y: to.y + 18 })
    await expect(this.#page.locator('.blocklyDragging')).toHaveCount(0)
  }

  async #joinsByKeys(block: string, sits: string) {
    await this.goesTo(block)
    await this.#page.keyboard.press('m')
    await expect(this.#page.locator('.blocklyDragging')).toHaveCount(1)
    // What would go out of its place is marked.
    const marked = this.#page.locator(`.blocklyReplaceable[data-id="${sits}"]`)
    for (let presses = 0; presses < 6 && (await marked.count()) === 0; presses += 1) {
      await this.#page.keyboard.press('ArrowDown')
      await this.#child.watches(2)
    }
    await this.#page.keyboard.press('Enter')
    await expect(this.#page.locator('.blocklyDragging')).toHaveCount(0)
  }

  /** Blocks of a type in the file that the child saves. */
  async inFile(type: string): Promise<readonly Block[]> {
    const project = JSON.parse(await this.#child.savesFile()) as Project
    return Object.values(project.programs).flatMap(({ stacks }) =>
      stacks.flatMap(({ blocks }) => blocks.filter((block) => block.type === type)),
    )
  }
}
