import { readFile } from 'node:fs/promises'
import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'

/** What a child does with the sign beside a learned number. */
export class ProofHands {
  readonly #child: Child

  constructor(child: Child) {
    this.#child = child
  }

  get dialog(): Locator {
    return this.#child.page.getByRole('dialog', { name: this.#child.word('proof.title'), exact: true })
  }

  async asks() {
    await this.#child.presses('proof.sign')
    await expect(this.dialog).toBeVisible()
  }

  async closes() {
    await this.dialog.getByRole('button', { name: this.#child.word('proof.close'), exact: true }).click()
    await expect(this.dialog).toBeHidden()
  }

  /** The sum that stands there. */
  async sum(): Promise<string> {
    return (await this.dialog.locator('.sum').textContent()) ?? ''
  }

  /** Saves the notebook: its name, and the number that it makes. */
  async saves(): Promise<{ readonly name: string; readonly number: number }> {
    const { page } = this.#child
    const save = this.dialog.getByRole('button', { name: this.#child.word('proof.save'), exact: true })
    const [download] = await Promise.all([page.waitForEvent('download'), save.click()])
    const { cells } = JSON.parse(await readFile(await download.path(), 'utf8')) as {
      readonly cells: readonly { readonly source: readonly string[] }[]
    }
    const data = cells.map(({ source }) => source.join('')).find((source) => source.includes('"shown"'))!
    return { name: download.suggestedFilename(), number: Number(/"shown": (.+)\n}/.exec(data)![1]) }
  }
}
