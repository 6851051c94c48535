import { expect, type Locator, type Page } from '@playwright/test'
import type { Child } from './child.ts'
import type { Asker } from './class-server.ts'
import { goesHome } from './navigation.ts'
import { projectFile } from './projects.ts'

let shares = 0

/** Shares a card's program with the class, as another device would. @returns its id */
export async function sharesOne(
  { asker }: { readonly asker: Asker },
  title: string,
  { program = 'solution', more = {} }: { readonly program?: string; readonly more?: object } = {},
): Promise<string> {
  const project = { ...(JSON.parse(projectFile('friendship', program)) as object), name: title, ...more }
  const { status, body } = await asker.ask('POST', `/gallery?share=share-${10_000 + ++shares}`, project)
  expect(status).toBe(201)
  return (body as { id: string }).id
}

/** A child in the gallery of its class. */
export class GalleryHands {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }
  get #page(): Page {
    return this.child.page
  }

  async opens() {
    await goesHome(this.child)
    const [me, name] = [this.#page.locator('.person > .button').first(), this.child.word('class.gallery')]
    const link = this.#page.getByRole('link', { name, exact: true })
    await expect(me).toBeVisible()
    if (await link.isVisible()) await link.click()
    else {
      // The menu of the pupil always has it: the link next to the menu is missing on a phone, and while the class loads.
      await me.click()
      await this.#page.locator('a.entry').filter({ hasText: name }).click()
    }
    await expect(this.child.button('gallery.shareOne')).toBeVisible()
  }

  /** What the list shows, in its order. */
  get titles(): Locator {
    return this.#page.locator('article h2')
  }
  tile(title: string): Locator {
    return this.#page
      .locator('article')
      .filter({ has: this.#page.getByRole('button', { name: title, exact: true }) })
  }
  heart(title: string, hearts: number): Locator {
    const facts = { title, hearts: this.child.word('gallery.hearts', { count: hearts }) }
    return this.tile(title).getByRole('button', { name: this.child.word('gallery.heart', facts) })
  }

  async looks(title: string) {
    const open = this.#page.getByRole('button', { name: title, exact: true })
    await open.click()
    await expect(this.looked.getByRole('heading', { name: title })).toBeFocused()
  }
  /** What is looked at, beside the list or over it. */
  get looked(): Locator {
    return this.#page.locator('section[aria-labelledby="looked"]')
  }
  /** Where its first robot stands in the picture. */
  place = async () => {
    const at = await this.looked.locator('svg g[transform*="scale"]').first().getAttribute('transform')
    return (at ?? '').match(/-?\d+(\.\d+)?/g)?.map((number) => Math.round(Number(number)))
  }
}
