import { expect, type Download } from '@playwright/test'
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { readFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import type { Child } from './child.ts'
import { goesHome } from './navigation.ts'

const folder = new URL('../packages/programs/testing/open-roberta/', import.meta.url)

/** A file that Open Roberta has saved, or one of the thesis. */
export const openRobertaFile = (path: string): string => readFileSync(new URL(`${path}.xml`, folder), 'utf8')

/** A child that comes from Open Roberta with its files. */
export class Comer {
  readonly #child: Child

  constructor(child: Child) {
    this.#child = child
  }

  get #page() {
    return this.#child.page
  }

  /** Chooses a file in the lab's menu. */
  async opens(name: string, text: string) {
    await this.#child.presses('lab.menu')
    await this.#chooses(name, text)
  }

  /** Chooses a file on the home page. */
  async opensAtHome(name: string, text: string) {
    await goesHome(this.#child)
    await this.#chooses(name, text)
  }

  /** Large files are passed as paths. */
  async #chooses(name: string, text: string) {
    const path = join(mkdtempSync(join(tmpdir(), 'open-roberta-')), name)
    writeFileSync(path, text)
    await this.#page.locator('input[type=file]').setInputFiles(path)
  }

  /** Holds a file over the page, and lets it go over what a selector finds. */
  async drops(name: string, text: string, over = 'body') {
    const files = await this.#page.evaluateHandle(
      ([name, text]) => {
        const held = new DataTransfer()
        held.items.add(new File([text], name))
        return held
      },
      [name, text] as const,
    )
    const place = this.#page.locator(over).first()
    // What is held over a page tells so again and again; a page that has just been opened hears it once it listens.
    await expect(async () => {
      await place.dispatchEvent('dragover', { dataTransfer: files })
      const said = this.#child.word('parts.dropFile')
      await expect(this.#page.locator('body')).toHaveAttribute('data-drop', said, { timeout: 500 })
    }).toPass({ timeout: 30_000 })
    await place.dispatchEvent('drop', { dataTransfer: files })
    await expect(this.#page.locator('body')).not.toHaveAttribute('data-drop')
  }

  async seesProgram(name: string) {
    await expect(this.#page.getByRole('heading', { level: 1 })).toHaveText(name)
    await this.#child.seesLab()
  }

  /** Saves the program for Open Roberta; `how` where it asks first, since it does not know all of it. */
  async saves(how?: 'asItIs' | 'asSteps'): Promise<{ readonly name: string; readonly text: string }> {
    await this.#child.presses('lab.menu')
    return this.takes(async () => {
      await this.#child.presses('lab.saveOpenRoberta')
      if (how) await this.#child.presses(`openRoberta.${how}`)
    })
  }

  async takes(press: () => Promise<void>) {
    const [download]: [Download, void] = await Promise.all([this.#page.waitForEvent('download'), press()])
    return {
      name: download.suggestedFilename(),
      text: await readFile(await download.path(), 'utf8'),
    }
  }

  async isToldWhy(problem: string, facts: { readonly [name: string]: string | number } = {}) {
    const dialog = this.#child.dialog(`problem.${problem}.title`)
    await expect(dialog).toContainText(this.#child.word(`problem.${problem}.text`, facts))
    await dialog.getByRole('button', { name: this.#child.word('parts.ok') }).click()
    await expect(dialog).toBeHidden()
  }
}
