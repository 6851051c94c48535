import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'
import { said } from './voice.ts'

/** Actions of a teacher with the learning materials. */
export class MaterialHands {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }

  get #page() {
    return this.child.page
  }

  link(key: string, facts = {}): Locator {
    return this.#page.getByRole('link', { name: this.child.word(key, facts), exact: true })
  }

  /** Fills the search field of the library. */
  finds(words: string) {
    return this.#page.getByRole('searchbox').fill(words)
  }

  /** From the library, or an item, to an item: `card/friendship`. */
  async opens(place: string) {
    const search = this.#page.getByRole('searchbox')
    const all = this.link('materials.all')
    await expect(search.or(all).first()).toBeVisible()
    if (!(await search.isVisible())) await all.click()
    await this.#page.locator(`.library a[href$="/materials/${place}"]`).first().click()
    await expect(search).toHaveCount(0)
    await this.seesDrawn()
  }

  /** Waits until the material is complete. */
  async seesDrawn() {
    await expect(this.#page.locator('.material[aria-busy="false"]').first()).toBeAttached()
  }

  /** Presses a button for reading aloud. Returns the text that the voice gets. */
  async reads(key: string, facts = {}): Promise<string> {
    const before = (await said(this.#page)).length
    await this.child.presses('comfort.read', { what: this.child.word(key, facts) })
    await expect.poll(() => said(this.#page)).toHaveLength(before + 1)
    return (await said(this.#page)).at(-1)!
  }
}
