import { expect, type Download, type Locator } from '@playwright/test'
import { readFile } from 'node:fs/promises'
import type { Child } from './child.ts'
import { closesDialog, opensFromHome } from './navigation.ts'

type Action = 'rename' | 'duplicate' | 'saveFile' | 'throw' | 'share'

/** A child at its list of projects. */
export class ProjectList {
  readonly #child: Child

  constructor(child: Child) {
    this.#child = child
  }

  get #page() {
    return this.#child.page
  }

  async opens() {
    await opensFromHome(this.#child, 'parts.myProjects')
    await this.isSeen()
  }

  async isSeen() {
    await expect(this.#page.getByRole('heading', { level: 1 })).toHaveText(
      this.#child.word('projects.question'),
    )
  }

  project(name: string): Locator {
    return this.#page
      .getByRole('article')
      .filter({ has: this.#page.getByRole('link', { name, exact: true }) })
  }

  /** Names of all projects that are shown, in their order. */
  names(): Promise<string[]> {
    return this.#page
      .locator('article h2')
      .allTextContents()
      .then((all) => all.map((name) => name.trim()))
  }

  async seesNames(...names: readonly string[]) {
    await expect.poll(() => this.names()).toEqual(names)
  }

  /** Begins an empty project under this name. */
  async begins(name: string) {
    await this.#child.presses('projects.new')
    await this.#page.getByLabel(this.#child.word('projects.name'), { exact: true }).fill(name)
    await this.#child.presses('projects.begin')
    await this.#child.seesLab()
  }

  async opensProject(name: string) {
    await this.#page.getByRole('link', { name, exact: true }).click()
    await this.#child.seesLab()
  }

  /** Chooses from the menu of a project. */
  async chooses(name: string, action: Action) {
    await this.project(name)
      .getByRole('button', { name: this.#child.word('projects.more', { name }), exact: true })
      .click()
    const word = action === 'share' ? 'parts.share' : `projects.${action}`
    await this.project(name)
      .getByRole('button', { name: this.#child.word(word), exact: true })
      .click()
  }

  async renames(from: string, to: string) {
    await this.chooses(from, 'rename')
    const field = this.#page.getByRole('textbox', { name: this.#child.word('projects.name') })
    await expect(field).toHaveValue(from)
    await field.fill(to)
    await this.#child.presses('projects.take')
    await this.hears('projects.renamed', { name: to })
  }

  /** What was done is said, where a screen reader hears it. */
  async hears(key: string, facts = {}) {
    const status = this.#page.getByRole('status').filter({ hasText: this.#child.word(key, facts) })
    await expect(status).toBeVisible()
  }

  async goesToBin() {
    await closesDialog(this.#child)
    const bin = this.#page.locator('a[href$="/projects/bin"]')
    if (!(await bin.isVisible())) await this.opens()
    await bin.click()
    await expect(this.#page.getByRole('heading', { level: 1 })).toHaveText(
      this.#child.word('projects.binTitle'),
    )
  }

  inBin(name: string): Locator {
    return this.#page
      .getByRole('listitem')
      .filter({ has: this.#page.getByRole('heading', { name, exact: true }) })
  }

  /** Opens a file from the list. */
  async opensFile(name: string, text: string) {
    const file = { name, mimeType: 'application/json', buffer: Buffer.from(text) }
    await this.#page.locator('input[type=file]').setInputFiles(file)
  }

  /** Takes everything home. Returns the text of the file. */
  async takesHome(): Promise<string> {
    const [download] = await Promise.all([
      this.#page.waitForEvent('download'),
      this.#child.presses('projects.takeHome'),
    ])
    expect(nameOf(download)).toMatch(/\.botgarten\.json$/)
    return readFile(await download.path(), 'utf8')
  }

  async isTold(title: string, text: string, facts = {}) {
    const dialog = this.#child.dialog(title)
    await expect(dialog).toContainText(this.#child.word(text, facts))
    await dialog.getByRole('button', { name: this.#child.word('parts.ok') }).click()
    await expect(dialog).toBeHidden()
  }

  /** What a busy browser does: the closing of the sentence before is told when the next one stands there. */
  isToldOfAnEarlierClosing(title: string) {
    return this.#child.dialog(title).dispatchEvent('close')
  }

  /** The link in the dialog that is open. */
  link(): Promise<string> {
    return this.#page.getByRole('textbox', { name: this.#child.word('share.address') }).inputValue()
  }
}

const nameOf = (download: Download) => download.suggestedFilename()
