import { expect } from '@playwright/test'
import { content } from '@botgarten/content/files'
import type { LoadedCage } from '@botgarten/content/catalogue'
import { untouched } from '@botgarten/maps/zoo'
import type { Child } from './child.ts'

/** What a child does and sees in the zoo of rewards. */
export class ZooVisitor {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }

  #text({ text }: LoadedCage) {
    return text[this.child.language]!
  }

  /** From home on to all cages. */
  async comes() {
    const { child } = this
    await child.opensHome()
    await this.child.press(child.page.getByRole('link', { name: child.word('home.zoo'), exact: true }))
  }

  async enters(cage: LoadedCage) {
    await this.child.press(this.child.page.getByRole('link', { name: this.#text(cage).title }))
  }

  async guesses(cage: LoadedCage) {
    const { guess } = this.#text(cage)
    await this.child.press(this.child.page.getByRole('button', { name: guess.wish, exact: true }))
  }

  /** Bo learns with the pay as it is; what it does then is said as the proof says. */
  async watches(cage: LoadedCage, outcome: keyof ReturnType<ZooVisitor['outcomes']>) {
    await this.child.press(this.child.button('zoo.learn'))
    await expect(
      this.child.page.getByText(this.outcomes(cage)[outcome], { exact: true }).first(),
    ).toBeVisible()
  }

  outcomes = (cage: LoadedCage) => this.#text(cage).does

  /** Move by move, as far as it is shown. */
  async steps() {
    const { child } = this
    await this.child.press(child.button('zoo.pause'))
    await this.child.press(child.button('zoo.oneMove'))
    const moved = child.word('zoo.moved', { from: '\\d+', to: '\\d+', reward: '[-−\\d.,]+' })
    await expect(child.page.getByText(new RegExp(moved))).toBeVisible()
  }

  /** Sets the pay of the solution: one of several, or the reward on a slider, key by key. */
  async mends(cage: LoadedCage) {
    const { page } = this.child
    const { mend, solution } = cage.cage
    if ('options' in mend) {
      const option = this.#text(cage).options[mend.options[solution]!.id]!
      return this.child.press(page.getByText(option, { exact: true }))
    }
    const slider = page.getByRole('slider', { name: this.#text(cage).mend })
    await slider.focus()
    const by = Math.round((solution - untouched(cage.cage)) / mend.step)
    await this.child.types(
      ...Array.from({ length: Math.abs(by) }, () => (by < 0 ? 'ArrowLeft' : 'ArrowRight')),
    )
    await expect(slider).toHaveValue(String(solution))
  }

  /** The same with a hand on the slider's knob. */
  async pullsReward(cage: LoadedCage) {
    const { child } = this
    const { mend, solution } = cage.cage
    if ('options' in mend) return
    const slider = child.page.getByRole('slider', { name: this.#text(cage).mend })
    await slider.scrollIntoViewIfNeeded()
    const { x, y, width, height } = (await slider.boundingBox())!
    // The knob's middle never leaves the track.
    const knob = height > 30 ? 16 : height
    const at = (reward: number) => ({
      x: x + knob / 2 + ((reward - mend.least) / (mend.most - mend.least)) * (width - knob),
      y: y + height / 2,
    })
    await child.drags(at(untouched(cage.cage)), at(solution))
  }

  async seesMended(cage: LoadedCage) {
    const safe = cage.cage.claim.aLot === 'wish'
    await expect(this.child.words(safe ? 'zoo.task.stillSafe' : 'zoo.task.done')).toBeVisible()
  }

  /** All cages say how many of them are mended. */
  async leaves(mended: number) {
    const { child } = this
    await this.child.press(child.page.getByRole('link', { name: child.word('zoo.back'), exact: true }))
    await expect(child.words('zoo.mendedOf', { count: mended, of: content.cages.length })).toBeVisible()
  }
}
