import { readFile } from 'node:fs/promises'
import { expect, type Locator } from '@playwright/test'
import type { Pose } from '@botgarten/simulation'
import { addToHash, hex, startHash } from '@botgarten/numbers'
import { layOutTraining, parametersIn } from '@botgarten/learning/neural-network/train'
import type { Child } from './child.ts'

/** cm between Bo's wheels, and how far from where it is wanted a hand may leave it. */
const wheelsApart = 18
const nearEnough = 3

/** So near a thing makes it turn, in cm; eyes that differ by less say the same. */
const close = 35
const alike = 8

const keyBy = ([left, right]: readonly number[]) =>
  Math.min(left!, right!) >= close ? 'ArrowUp' : left! > right! + alike ? 'ArrowLeft' : 'ArrowRight'
/** To which side a child steers: right is 1, left −1, and 0 where nothing is near. */
const awayFromNear = ([left, right]: readonly number[]): number => {
  if (Math.min(left!, right!) >= 65) return 0
  return left! < right! ? 1 : -1
}

/** The examples of the printed picture: two eyes in cm, two wheels in %. */
export const sixRows = `eyeLeft,eyeRight,wheelLeft,wheelRight
40,40,45,45
39,59,25,60
68,100,50,90
100,53,65,25
29,28,25,25
7,7,0,0
`

/** The hash of the weights after `botgarten learn net friendship --examples rows.csv --rounds 60 --json` in Node. */
export const weightsOfSixRows = '7c9b35e4ad6dddfa'

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
    await this.#child.press(
      ways.getByRole('button', { name: this.#child.word('network.showIt'), exact: true }),
    )
    await expect(this.table).toBeVisible()
  }

  async letsPractise() {
    await this.#child.presses('network.letPractise')
    // In a low pane the curve comes with the first round.
    await expect(this.#child.button('training.practise').first()).toBeVisible()
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
    await this.#child.press(this.#page.locator('.hand .main').getByRole('button'))
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
    await this.#child.press(
      modes.getByRole('button', { name: this.#child.word(`training.mode.${mode}`), exact: true }),
    )
  }

  /** Holds an arrow key on the pad until something has come of it. */
  async drivesUntil(seen: () => Promise<void>) {
    await this.pad.focus()
    await this.#page.keyboard.down('ArrowUp')
    await seen()
    await this.#page.keyboard.up('ArrowUp')
  }

  /**
   * Drives by the arrow keys until there are so many examples: ahead, and where an eye sees something near, on the spot away
   * from it; to the right where both see it alike.
   */
  async dodges(count: number) {
    await this.pad.focus()
    const { keyboard } = this.#page
    let held = ''
    for (let now = await this.#sees(); now.rows < count; now = await this.#sees()) {
      const key = keyBy(now.eyes)
      if (key === held) continue
      await keyboard.down(key)
      if (held) await keyboard.up(held)
      held = key
    }
    await keyboard.up(held)
  }

  /** What Bo's eyes say, left and right, and how many examples there are. */
  #sees(): Promise<{ eyes: number[]; rows: number }> {
    return this.#page.evaluate(() => {
      const { brains, networks } = globalThis.botgarten!.view()!
      const [brain] = Object.values(brains)
      const outputs = Object.values(networks)[0]?.outputs ?? {}
      const eyes = brain!.layers[0]!.map(({ id }) => outputs[id] ?? 100)
      return { eyes, rows: brain!.examples?.rows.length ?? 0 }
    })
  }

  /** Sets these words, counted from 0, and no other, and remembers that. */
  async remembersWords(words: readonly number[]) {
    const group = this.#page.getByRole('group', { name: this.#child.word('training.others'), exact: true })
    await this.#child.press(
      group.getByRole('button', { name: this.#child.word('training.nothing'), exact: true }),
    )
    for (const word of words) await this.#child.press(group.getByRole('button').nth(word))
    await this.#child.press(this.#page.locator('.hand .main').getByRole('button'))
  }

  /** Bo drives with its network. Once an eye reads less than 65 the child holds the pad aside, until nothing is near any more. */
  async helps() {
    // To press the button may scroll the pad.
    await this.#child.presses('training.begin.coach')
    const box = (await this.pad.boundingBox())!
    const [x, y] = [box.x + box.width / 2, box.y + box.width / 2]
    const reach = (box.width * 38) / 116
    let held = 0
    const { grip } = this.#child
    const hold = async (side: number) => {
      if (side === held) return
      const at = { x: x + 0.225 * side * reach, y: y - 0.375 * reach }
      if (side === 0) await grip.up()
      else await (held === 0 ? grip.down(at) : grip.move(at))
      held = side
    }
    do await hold(awayFromNear((await this.#sees()).eyes))
    while (held === 0)
    while (held !== 0) await hold(awayFromNear((await this.#sees()).eyes))
    await this.#child.presses('training.pause')
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
    await this.#child.press(
      this.#page.getByRole('switch', { name: this.#child.word('training.mirror'), exact: true }),
    )
    await this.#child.types('Escape')
  }

  /** Chooses the speed and how many rounds it practises, by their names. */
  async setsUp(settings: { readonly rate?: number; readonly rounds?: number }) {
    for (const [key, value] of [
      ['training.speed', settings.rate],
      ['training.roundsLabel', settings.rounds],
    ] as const)
      if (value !== undefined) {
        const choice = this.#page.getByRole('combobox', { name: this.#child.word(key), exact: true })
        await choice.selectOption({ label: this.#nameOf(value) })
      }
  }

  /** A number as a choice calls it; beginners choose speeds by words. */
  #nameOf(value: number): string {
    const speeds: { readonly [rate: string]: string } = { 0.03: 'slow', 0.1: 'medium', 0.3: 'fast' }
    const speed = speeds[value]
    return speed ? this.#child.word(`training.${speed}`) : value.toLocaleString(this.#child.language)
  }

  async practises() {
    await this.#child.press(this.#page.locator('.practise .bar .button.network'))
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
