import { readFile } from 'node:fs/promises'
import { expect, type Locator } from '@playwright/test'
import type { Pose } from '@botgarten/simulation'
import { addToHash, hex, startHash } from '@botgarten/numbers'
import { layOutTraining, parametersIn } from '@botgarten/learning/neural-network/train'
import type { Child } from './child.ts'

/** cm between Bo's wheels, and how far from where it is wanted a hand may leave it. */
const wheelsApart = 18
const nearEnough = 3

/** What a child does to teach a network by examples. */
export class Teaching {
  readonly #child: Child

  constructor(child: Child) {
    this.#child = child
  }

  get #page() {
    return this.#child.page
  }

  async shows() {
    // In German the project of a card is called like this way.
    const ways = this.#page.getByRole('toolbar', { name: this.#child.word('network.ways'), exact: true })
    await ways.getByRole('button', { name: this.#child.word('network.showIt'), exact: true }).click()
    await expect(this.table).toBeVisible()
  }

  async letsPractise() {
    await this.#child.presses('network.letPractise')
    await expect(this.curve).toBeVisible()
  }

  get table(): Locator {
    return this.#page.getByRole('region', { name: this.#child.word('training.table'), exact: true })
  }
  get curve(): Locator {
    return this.#page.getByRole('slider', { name: new RegExp(`^${this.#child.word('training.curveLabel')}`) })
  }
  get pad(): Locator {
    return this.#page.locator('.pad')
  }

  /** Sets both wheels by their sliders and remembers that. */
  async remembers(left: number, right: number) {
    for (const [key, value] of [
      ['training.leftWheel', left],
      ['training.rightWheel', right],
    ] as const)
      await this.#page.getByRole('slider', { name: this.#child.word(key), exact: true }).fill(`${value}`)
    await this.#page.locator('.hand .main').getByRole('button').click()
  }

  /** Puts Bo somewhere: drags it there, once more where that was not near enough, and turns it by steps of 5 degrees. */
  async puts({ x, y, heading }: Pose) {
    const { painted, bo } = this.#child
    const pxPerCm = (await painted.wheelsApart()) / wheelsApart
    for (let drags = 0; drags < 4; drags += 1) {
      const stands = await this.#stands()
      if (Math.hypot(x - stands.x, y - stands.y) < nearEnough) break
      const from = await painted.place('bo')
      const to = { x: from.x + (x - stands.x) * pxPerCm, y: from.y - (y - stands.y) * pxPerCm }
      await this.#child.drags(from, to)
    }
    await bo.focus()
    const turn = ((heading - (await this.#stands()).heading + 540) % 360) - 180
    for (let turns = Math.round(Math.abs(turn) / 5); turns > 0; turns -= 1)
      await this.#child.types(turn > 0 ? ',' : '.')
  }

  async #stands(): Promise<Pose> {
    const [x, y, heading] = (await this.#child.boStands()).split(',').map(Number)
    return { x: x!, y: y!, heading: heading! }
  }

  async chooses(mode: 'remember' | 'drive' | 'coach' | 'copy') {
    const modes = this.#page.getByRole('group', { name: this.#child.word('training.modes') })
    await modes.getByRole('button', { name: this.#child.word(`training.mode.${mode}`), exact: true }).click()
  }

  /** Holds an arrow key on the pad until something has come of it. */
  async drivesUntil(seen: () => Promise<void>) {
    await this.pad.focus()
    await this.#page.keyboard.down('ArrowUp')
    await seen()
    await this.#page.keyboard.up('ArrowUp')
  }

  /** How many examples there are, as the table says. */
  async count(): Promise<number> {
    return Number(await this.#page.locator('.show .head p b').textContent())
  }

  async seesExamples(count: number) {
    await expect(this.#page.locator('.show .head p b')).toHaveText(`${count}`)
  }

  /** Rows of a long table are there when they are scrolled to. */
  async setsAside(row: number) {
    await this.table.hover()
    const button = this.#child.button('training.setRowAside', { row }).first()
    for (let turns = 0; turns < 60 && (await button.count()) === 0; turns++)
      await this.#page.mouse.wheel(0, turns < 30 ? -90 : 90)
    await this.#child.presses('training.setRowAside', { row })
  }

  async takesBack(row: number) {
    await this.#child.presses('training.takeRowBack', { row })
  }

  async opensFile(name: string, text: string) {
    const file = { name, mimeType: 'text/csv', buffer: Buffer.from(text) }
    await this.#page.locator('.show input[type=file]').setInputFiles(file)
  }

  /** Saves the examples. Returns what the file says. */
  async saves(key: 'training.saveCsv' | 'training.saveJson'): Promise<string> {
    await this.#child.presses('training.files')
    const download = this.#page.waitForEvent('download')
    await this.#child.presses(key)
    return readFile(await (await download).path(), 'utf8')
  }

  async switchesMirror() {
    await this.#child.presses('training.more')
    await this.#page.getByRole('switch', { name: this.#child.word('training.mirror'), exact: true }).click()
    await this.#child.types('Escape')
  }

  async practises() {
    await this.#page.locator('.practise .bar .button.network').click()
    await expect(this.#page.getByText(this.#child.word('training.done'), { exact: true })).toBeVisible()
  }

  /** 64 bits over the weights on the knobs, as the command line counts them. */
  async hashOfWeights(): Promise<string> {
    const brain = await this.#page.evaluate(() => Object.values(globalThis.botgarten!.view()!.brains)[0]!)
    const hash = startHash()
    for (const value of parametersIn(layOutTraining(brain.layers), brain.weights)) addToHash(hash, value)
    return hex(hash)
  }
}
