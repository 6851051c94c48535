import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'

/** What a child does with time and with several robots. */
export class TimeHands {
  readonly #child: Child

  constructor(child: Child) {
    this.#child = child
  }

  get slider(): Locator {
    return this.#child.page.getByRole('slider', { name: this.#child.word('time.slider'), exact: true })
  }

  /** Opens the bar of time. */
  async opens() {
    await this.#child.presses('time.open')
    await expect(this.slider).toBeVisible()
  }

  /** Seconds that the slider stands at. */
  async at(): Promise<number> {
    return Number(await this.slider.getAttribute('aria-valuenow'))
  }

  /** Lets it run until so many seconds of simulated time are over, then waits. */
  async runsUntil(seconds: number) {
    await expect.poll(() => this.at(), { intervals: [50] }).toBeGreaterThan(seconds)
    await this.#child.presses('lab.pause')
  }

  async goesBack(...keys: readonly string[]) {
    await this.slider.focus()
    await this.#child.types(...keys)
    await expect(this.#child.button('time.goOn')).toBeVisible()
  }

  get speed(): Locator {
    return this.#child.page.getByRole('combobox', { name: this.#child.word('time.speed'), exact: true })
  }

  /** Lets time run as fast as it can. */
  async hurries() {
    await this.chooses('Infinity')
  }

  /** The same by keys alone. */
  async hurriesByKeys() {
    await this.#child.tabsTo(this.speed)
    await this.#child.types('End')
  }

  async chooses(speed: string) {
    await this.speed.selectOption(speed)
  }

  // ---- several robots ----

  robotName(number: number): string {
    return number === 1 ? this.#child.word('world.robot') : this.#child.word('robots.name', { number })
  }

  /** The chip of a robot in the row. */
  chip(number: number): Locator {
    return this.row.getByRole('button', { name: this.robotName(number), exact: true })
  }

  get row(): Locator {
    return this.#child.page.getByRole('group', { name: this.#child.word('robots.choose') })
  }

  /** A robot in the world. */
  robot(number: number): Locator {
    const world = this.#child.page.getByRole('application')
    return world.getByRole('button', { name: this.robotName(number), exact: true })
  }

  stands(number: number): Promise<string> {
    return this.#child.painted.stands(number)
  }

  /** Asks for one robot more: the first one comes from the world's menu, the others from the row. */
  async asks() {
    const hasRoom = await this.#child.button('lab.worldSettings').isVisible()
    if ((await this.row.count()) === 0) await this.#child.presses(hasRoom ? 'lab.worldSettings' : 'lab.menu')
    await this.#child.press(this.#child.button('robots.add').last())
  }

  async adds(kind: 'shared' | 'own') {
    await this.asks()
    await this.#child.presses(`robots.${kind}`)
  }
}
