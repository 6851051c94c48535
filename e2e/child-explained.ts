import { expect, type Locator } from '@playwright/test'
import { BlockHands } from './child-blocks.ts'
import type { Child } from './child.ts'
import { finger } from './hand.ts'
import { message, type Language } from './words.ts'

/** The sentence that says what a block does. */
const helpOf = (type: string, language: Language): string => message(language, `block.${type}.help`)

/** Hands that ask what a block does. */
export class AskingHands {
  readonly #child: Child
  readonly blocks: BlockHands

  constructor(child: Child) {
    this.#child = child
    this.blocks = new BlockHands(child)
  }

  get item(): Locator {
    return this.#child.page.getByRole('menuitem', { name: this.#child.word('editor.what') })
  }
  get dialog(): Locator {
    return this.#child.dialog('editor.what')
  }
  get example(): Locator {
    return this.dialog.getByRole('img', { name: this.#child.word('shelf.example') })
  }
  /** A block of the row of the shelf that is open. */
  onShelf(at = 0): Locator {
    return this.#child.page.locator('.blocklyFlyout .blocklyDraggable').nth(at)
  }

  async asksByMenu(block: Locator) {
    await block.click({ ...this.blocks.corner, button: 'right' })
    await this.item.click()
  }

  /** A finger rests on a block until its menu is there. */
  async asksByFinger(block: Locator) {
    const { x, y } = (await block.boundingBox())!
    const hand = finger(this.#child.page)
    await hand.down({ x: x + 12, y: y + 12 })
    await expect(this.item).toBeVisible()
    await hand.up()
    await this.item.tap()
  }

  async isTold(type: string) {
    await expect(this.dialog.getByText(helpOf(type, this.#child.language))).toBeVisible()
    await expect(this.example).toBeVisible()
  }

  async takesIt() {
    await this.dialog.getByRole('button', { name: this.#child.word('shelf.take') }).click()
    await expect(this.dialog).toBeHidden()
  }
}
