import { expect, type Locator } from '@playwright/test'
import { leftEye, leftWheel, rightEye, rightWheel, type Child, type Motor } from './child.ts'

/** What a child asks about the inside of a network. */
export class Asker {
  readonly #child: Child

  constructor(child: Child) {
    this.#child = child
  }

  /** The panel that answers. */
  get panel(): Locator {
    return this.#child.page.locator('section.inside')
  }

  /** Asks why the motor that is shown turns. */
  async asksWhy() {
    await this.#child.presses('network.why')
    await this.seesAnswer()
  }

  async seesAnswer() {
    await expect(this.panel.getByRole('heading')).toBeVisible()
  }

  async asksAbout(motor: Motor) {
    await this.#child.output(motor).click()
  }

  /** With every knob at 1 Bo drives into the square. */
  async crashes() {
    await this.#child.opensLab('friendship')
    for (const eye of [leftEye, rightEye])
      for (const wheel of [leftWheel, rightWheel]) await this.#child.typesWeight(eye, wheel, 1)
    await this.#child.pressesStart()
    await expect(this.#child.words('session.bumped')).toBeVisible()
  }

  /** Bo circles, and is asked on its way. */
  async asksOnTheWay() {
    await this.#child.opensLab('friendship')
    await this.#child.typesWeight(leftEye, leftWheel, 0.6)
    await this.#child.typesWeight(leftEye, rightWheel, 0.25)
    await this.#child.pressesStart()
    await this.#child.seesDriving()
    await this.asksWhy()
  }

  eye(place: string): Locator {
    return this.#child.button('inside.leaveOut', { input: this.#child.word(`network.place.${place}`) })
  }

  /** Every whole number that stands beside a bar; the last one is the sum. */
  async shares(): Promise<number[]> {
    const texts = await this.panel.locator('strong').allTextContents()
    return texts.map((text) => Number(text.replace('−', '-').replace(',', '.')))
  }

  async seesSharesAddUp() {
    const shares = await this.shares()
    const parts = shares.slice(0, -1).reduce((sum, share) => sum + share, 0)
    expect(Math.round(parts * 10)).toBe(Math.round(shares.at(-1)! * 10))
  }

  /** What stands under the pale robot. */
  pale(key: string, facts: { readonly [name: string]: string }): Locator {
    return this.#child.page.getByRole('application').getByText(this.#child.word(key, facts), { exact: true })
  }

  get change(): Locator {
    return this.panel.getByRole('button', { name: this.#child.word('inside.smallest') })
  }
}
