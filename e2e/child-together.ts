import { expect, type Locator, type Page } from '@playwright/test'
import type { Child } from './child.ts'
import { Pupil } from './child-class.ts'
import type { MadeClass } from './made-class.ts'

/** A child that works with a classmate on one program. */
export class TogetherHands {
  readonly child: Child
  readonly #pupil: Pupil

  constructor(child: Child, school: MadeClass) {
    this.child = child
    this.#pupil = new Pupil(child, school)
  }
  get #page(): Page {
    return this.child.page
  }

  /** Asks a classmate, by keys. */
  async asks(nickname: string) {
    await this.#pupil.me.focus()
    await this.#page.keyboard.press('Enter')
    await this.child.tabsAndPresses('class.together')
    const mate = this.#page.getByRole('dialog').getByRole('button', { name: nickname, exact: true })
    await this.child.tabsTo(mate)
    await this.#page.keyboard.press('Enter')
    await expect(mate).toHaveCount(0)
  }
  /** Accepts with a finger. */
  async accepts() {
    await this.child.button('class.togetherYes').tap()
    await this.seesBar()
  }
  get bar(): Locator {
    return this.#page.getByRole('region', { name: this.child.word('class.togetherBar') })
  }
  async seesBar() {
    await expect(this.child.button('class.togetherSwap')).toBeVisible()
  }
  /** What this child is now. */
  async isThe(role: 'hand' | 'eye') {
    const { child } = this
    await expect(this.bar).toContainText(
      new RegExp(`${child.word('class.togetherMe')}\\s+${child.word(`class.${role}`)}`),
    )
  }
  async seesSame() {
    await expect(this.bar).toContainText(this.child.word('class.togetherSame'))
  }
  async seesAway() {
    await expect(this.bar).toContainText(this.child.word('class.togetherAway'))
  }
  /** The hand of the other one, over the blocks. */
  handOf(name: string): Locator {
    return this.#page.getByRole('img', { name: this.child.word('class.togetherHand', { name }) })
  }
  /** Around the block that the other one has chosen. */
  get chosen(): Locator {
    return this.#page.locator('.chosen-by-other')
  }
  /** All blocks by their names in the project. */
  async blocks(): Promise<readonly string[]> {
    const all = await this.child.canvas
      .locator('.blocklyDraggable')
      .evaluateAll((blocks) => blocks.map((block) => block.getAttribute('data-id') ?? ''))
    return all.toSorted()
  }
  async leaves() {
    await this.child.presses('class.togetherLeave')
    const question = this.#page.getByRole('dialog')
    await question.getByRole('button', { name: this.child.word('class.togetherLeave') }).click()
    await expect(this.bar).toHaveCount(0)
  }
}
