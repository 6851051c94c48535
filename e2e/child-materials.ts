import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'
import { seesParts } from './drawn.ts'
import { said } from './voice.ts'

const drawn = {
  'main img': ['src'],
  '.robot > svg, .paper-code > svg': ['viewBox'],
  'main svg path': ['d'],
  'main svg polyline': ['points'],
  '.robot text': ['x', 'y', 'text-anchor'],
  '.robot > svg > circle': ['cx', 'cy'],
  '.flow-diagram rect, .flow-diagram text': ['x', 'y'],
  '.flow-diagram .head': ['transform'],
}

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

  /** Waits until the page is complete and no part of its drawings lacks an attribute: the tree does not list them. */
  async seesDrawn() {
    await expect(this.#page.locator('.material[aria-busy="false"]').first()).toBeAttached()
    await seesParts(this.#page, drawn)
  }

  /** Presses a button for reading aloud. Returns the text that the voice gets. */
  async reads(key: string, facts = {}): Promise<string> {
    const before = (await said(this.#page)).length
    await this.child.presses('comfort.read', { what: this.child.word(key, facts) })
    await expect.poll(() => said(this.#page)).toHaveLength(before + 1)
    return (await said(this.#page)).at(-1)!
  }
}
