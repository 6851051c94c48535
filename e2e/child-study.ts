import { spawnSync } from 'node:child_process'
import { readFile } from 'node:fs/promises'
import { expect } from '@playwright/test'
import { pseudonymOf } from '../packages/experiments/study/index.ts'
import { inHouse } from '../scripts/prepare/house.mjs'
import type { Child } from './child.ts'
import { opensFromHome } from './navigation.ts'

/** A study of two modules, as its file. */
export const studyFile = (change = {}) =>
  JSON.stringify({
    ...{ botgarten: 'study', version: 1, id: 'autumn', title: 'Autumn', seed: 7, groups: 4, children: 9 },
    modules: [
      { id: 'net', title: 'Neurons', cards: ['friendship'] },
      { id: 'q', title: 'Trying', cards: ['fear', 'free'] },
    ],
    ...{ order: 'fixed', level: 'plain', maps: ['city'], log: true, word: 'Kiesel7' },
    ...change,
  })

/** What a researcher and the children of a study do on one device. */
export class StudyHands {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }

  get #page() {
    return this.child.page
  }

  /** From all materials on to the page of study mode. */
  async comes() {
    await opensFromHome(this.child, 'home.materials')
    await this.#page.getByRole('link', { name: this.child.word('materials.study') }).click()
    await expect(this.child.words('study.lead')).toBeVisible()
  }

  async opens(text = studyFile()) {
    const file = { name: 'study.json', mimeType: 'application/json', buffer: Buffer.from(text) }
    await this.#page.locator('input[type=file]').setInputFiles(file)
  }

  /** The researcher opens the study, has the consents, and hands the device out. */
  async handsOut(text = studyFile()) {
    await this.comes()
    await this.opens(text)
    await this.#page.getByLabel(this.child.word('study.consentBox')).check()
    await this.child.presses('study.handOut')
  }

  async saysNumber(group: number, number: number) {
    await this.#page.getByLabel(this.child.word('study.number')).fill(pseudonymOf(group, number))
  }

  /** A child sits down and says yes or no to the log. */
  async begins(group: number, number: number, answer: 'yes' | 'no' = 'yes') {
    await this.saysNumber(group, number)
    await this.child.presses(`study.${answer}`)
  }

  async opensCard(card: string) {
    await this.#page.locator(`a[href$="/lab/${card}"]`).click()
    await this.child.seesLab()
  }

  /** From a card back to the page of the study: the link home leads there. */
  async goesBack() {
    await this.#page.locator('a[href$="/"]:visible').first().click()
    await expect(this.child.button('study.end').first()).toBeVisible()
  }

  /** The child is done; the next one can come. */
  async ends() {
    await this.goesBack()
    await this.child.presses('study.end')
    await this.#page
      .getByRole('dialog')
      .getByRole('button', { name: this.child.word('study.sure'), exact: true })
      .click()
    await expect(this.child.words('study.hello')).toBeVisible()
  }

  /** Back to the researcher's page. */
  async saysWord(word = 'kiesel7') {
    await this.child.presses('study.researcher')
    await this.#page.getByLabel(this.child.word('study.word'), { exact: true }).fill(word)
    await this.child.presses('study.enter')
  }

  /** All logs of the device as a file. */
  async takesLogs(): Promise<{ readonly path: string; readonly text: string }> {
    const [download] = await Promise.all([
      this.#page.waitForEvent('download'),
      this.child.presses('study.saveAll'),
    ])
    const path = await download.path()
    return { path, text: await readFile(path, 'utf8') }
  }
}

interface Replayed {
  readonly runs: readonly { readonly same: boolean; readonly photo: boolean; readonly ticks: number }[]
  readonly pupils: readonly { readonly pseudonym: string; readonly tries: number; readonly knobs: number }[]
}

/** What the command line says of a log that came out of the browser. */
export function replayed(path: string): Replayed {
  const call = [inHouse('apps', 'cli', 'botgarten.ts'), 'replay', path, '--json', '--lang', 'en']
  const { stdout, stderr } = spawnSync(process.execPath, call, { encoding: 'utf8' })
  expect(stderr).toBe('')
  return JSON.parse(stdout) as Replayed
}
