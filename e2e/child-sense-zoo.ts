import { expect } from '@playwright/test'
import type { LoadedSenseCage } from '@botgarten/content/catalogue'
import { unitOf } from '@botgarten/learning/q-senses'
import type { Child } from './child.ts'

/** What a child does and sees in the wing of the zoo in which Bo tries with its own sensors. */
export class SenseVisitor {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }

  #text({ text }: LoadedSenseCage) {
    return text[this.child.language]!
  }

  /** From home on to all cages. */
  async comes() {
    const { child } = this
    await child.opensHome()
    await child.press(child.page.getByRole('link', { name: child.word('home.zoo'), exact: true }))
  }

  async enters(cage: LoadedSenseCage) {
    await this.child.press(this.child.page.getByRole('link', { name: this.#text(cage).title, exact: true }))
    await expect(this.child.page.getByText(this.#text(cage).soundsRight, { exact: true })).toBeVisible()
  }

  async guesses(cage: LoadedSenseCage) {
    await this.child.press(
      this.child.page.getByRole('button', { name: this.#text(cage).guess.honest, exact: true }),
    )
  }

  /** Bo drives what it has learned: what is said then is what its row says. */
  async watches(cage: LoadedSenseCage) {
    const { does } = this.#text(cage)
    await this.child.presses('zoo.senses.watch')
    const { bos, shown } = cage.rows
    const said = bos.find(({ seed }) => seed === shown.seed)!.cheats ? does.cheats : does.other
    await expect(this.child.page.getByText(said, { exact: true })).toBeVisible({ timeout: 60_000 })
  }

  /** Chooses the pay of the cage's mend, sentence by sentence. */
  async mends({ cage }: LoadedSenseCage) {
    const { child } = this
    for (const [index, { for: kind, coins }] of cage.mend.entries()) {
      const number = index + 1
      if (index >= cage.trial.pay.length) await child.presses('zoo.senses.add')
      await child.page
        .getByRole('combobox', { name: child.word('zoo.senses.what', { number }), exact: true })
        .selectOption(kind)
      const field = child.page.getByRole('spinbutton', {
        name: child.word('zoo.senses.coins', { number }),
        exact: true,
      })
      await field.fill(String(coins * unitOf(kind)))
      await field.press('Tab')
    }
    for (let number = cage.trial.pay.length; number > cage.mend.length; number -= 1)
      await child.presses('zoo.senses.remove', { number })
  }

  /** Bos try the new pay one after the other, until one drives as is meant. */
  async triesUntilMended() {
    const { child } = this
    const done = child.words('zoo.senses.task.done')
    const notYet = child.words('zoo.senses.task.again')
    await child.presses('zoo.senses.try')
    for (let bos = 1; bos < 12; bos += 1) {
      await expect(done.or(notYet)).toBeVisible({ timeout: 120_000 })
      if (await done.isVisible()) return
      await child.presses('zoo.senses.another')
      await expect(notYet).toBeHidden()
    }
    throw new Error('No Bo drives as is meant.')
  }

  async leaves() {
    const { child } = this
    await child.press(child.page.getByRole('link', { name: child.word('zoo.back'), exact: true }))
  }
}
