import { content } from '@botgarten/content/files'
import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'
import type { Spot } from './hand.ts'
import { opensFromHome } from './navigation.ts'

/** What a child does in the sorting playground. */
export class SortingHands {
  readonly #child: Child

  constructor(child: Child) {
    this.#child = child
  }

  word = (key: string, facts = {}) => this.#child.word(`sorting.${key}`, facts)
  words = (key: string, facts = {}) => this.#child.words(`sorting.${key}`, facts)
  presses = (key: string, facts = {}) => this.#child.presses(`sorting.${key}`, facts)

  async opens(source: 'things' | 'points' | 'readings' = 'things') {
    await opensFromHome(this.#child, 'home.sorting')
    await expect(this.plane).toBeVisible()
    // Its size follows from the lines around it.
    await this.#child.page.evaluate(() => document.fonts.ready.then(() => null))
    if (source !== 'things') await this.presses(`tab.${source}`)
  }

  /** Four points, sorted, as a project named "Marbles" whose first group is named "Mine". */
  async makesMarbles() {
    await this.opens('points')
    await this.draws([-150, -100], [-140, -90], [150, 100], [140, 110])
    await this.sorts()
    await this.group(1).fill('Mine')
    await this.renames('Marbles')
  }

  /** The project of `makesMarbles`, with its result. */
  async seesMarbles() {
    await expect(this.title).toHaveText('Marbles')
    await this.seesPoints(4)
    await this.seesDone()
    await expect(this.group(1)).toHaveValue('Mine')
  }

  get plane(): Locator {
    return this.#child.page.getByRole('application')
  }

  flag(number: number): Locator {
    return this.#child.page.getByRole('button', { name: this.word('flag', { number }), exact: true })
  }

  get flags(): Locator {
    return this.#child.page.getByRole('button', {
      name: new RegExp(`^${this.word('flag', { number: '\\d' })}$`),
    })
  }

  feature(name: string): Locator {
    return this.#child.page.getByRole('switch', { name: this.word(`feature.${name}`), exact: true })
  }

  group(number: number): Locator {
    return this.#child.page.getByRole('textbox', { name: this.word('nameOf', { number }), exact: true })
  }

  thing(kind: string, number: number): Locator {
    return this.#child.page.getByRole('button', {
      name: `${this.word(`kind.${kind}`)} ${number}`,
      exact: true,
    })
  }

  /** Where flag 1 and all others stand. */
  places(): Promise<string[]> {
    return this.flags.evaluateAll((flags) => flags.map((flag) => (flag as HTMLElement).style.transform))
  }

  async middleOfPlane(): Promise<Spot> {
    return this.#child.middleOf(this.plane)
  }

  /** Steps by hand until no flag moves any more. */
  async sorts() {
    for (let round = 0; round < 40; round += 1) {
      if (await this.isDone()) return
      await this.presses((await this.isOff('join')) ? 'move' : 'join')
    }
    throw new Error('The flags still move.')
  }

  isDone = async () => (await this.isOff('join')) && (await this.isOff('move'))
  isOff = async (key: 'join' | 'move') =>
    (await this.#child.button(`sorting.${key}`).getAttribute('aria-disabled')) === 'true'

  async seesDone() {
    await expect(this.#child.page.getByText(this.word('say.done'))).toBeVisible()
  }

  /** How far the touched thing is from every flag is said. */
  async hearsDistances(flags: number) {
    for (let flag = 1; flag <= flags; flag += 1) {
      const words = new RegExp(this.word('awayFrom', { flag, away: '[\\d.,]+' }))
      await expect(this.#child.page.getByText(words)).toHaveCount(1)
    }
  }

  async opensTable(text: string) {
    const file = { name: 'table.csv', mimeType: 'text/csv', buffer: Buffer.from(text) }
    await this.#child.page.locator('input[type=file]').setInputFiles(file)
  }

  /** Shows a data set of points; '' for the own ones. */
  async takesPoints(set: string) {
    await this.#child.page
      .getByRole('combobox', { name: this.word('pointsFrom'), exact: true })
      .selectOption(set)
  }

  /** Draws own points, by px from the middle of the plane. */
  async draws(...places: readonly (readonly [right: number, down: number])[]) {
    await this.takesPoints('')
    await this.presses('tool.add')
    const { x, y } = await this.middleOfPlane()
    for (const [right, down] of places) await this.#child.page.mouse.click(x + right, y + down)
    await this.presses('tool.look')
  }

  /** Gives the project another name. */
  async renames(name: string) {
    await this.#child.page.getByTitle(this.#child.word('lab.rename')).click()
    const field = this.#child.page.getByRole('textbox', { name: this.#child.word('lab.rename') })
    await field.fill(name)
    await field.press('Enter')
    await expect(this.title).toHaveText(name)
  }

  get title(): Locator {
    return this.#child.page.getByRole('heading', { level: 1 })
  }

  async seesPoints(count: number) {
    await expect(this.plane).toHaveAttribute('aria-label', this.word('plane', { count }))
  }
}

/** A card of sorting with one of its programs, as a project file. */
export function sortingProject(card: 'tidy-up' | 'new-colours', program: string): string {
  return JSON.stringify({
    ...{ botgarten: 1, name: 'Mine', card, assets: {} },
    ...content.program(card, program),
    world: content.card(card)!.world,
  })
}
