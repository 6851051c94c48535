import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { expect, type Locator, type Page } from '@playwright/test'
import { readFile } from 'node:fs/promises'
import { finger, mouse, type Hand, type HandName, type Spot } from './hand.ts'
import { bedsOf, findsCard, goesHome, opensCard, opensFreeLab } from './navigation.ts'
import { Painted } from './painted.ts'
import { message, cardMessage, checkMessage, type Language } from './words.ts'

/** A neuron as a child would point at it: what it is, where it is plugged in and where it sits. */
export interface Sensor {
  readonly sensor: 'distance' | 'light'
  readonly port: string
  readonly place: 'front' | 'frontLeft' | 'frontRight'
}
export interface Motor {
  readonly motor: string
  readonly place: 'left' | 'right'
}

export const leftEye: Sensor = { sensor: 'distance', port: '2', place: 'frontLeft' }
export const rightEye: Sensor = { sensor: 'distance', port: '3', place: 'frontRight' }
export const leftWheel: Motor = { motor: 'C', place: 'left' }
export const rightWheel: Motor = { motor: 'B', place: 'right' }

const middleOf = async (thing: Locator): Promise<Spot> => {
  const box = await thing.boundingBox()
  if (box === null) throw new Error('Nothing to take hold of.')
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
}

/** Does with the screen what a child does, and sees what a child sees, in the child's language. */
export class Child {
  readonly page: Page
  readonly hand: HandName
  /** Holds and moves something for as long as it likes. */
  readonly grip: Hand
  /** What the canvases show. */
  readonly painted: Painted
  language: Language

  constructor(page: Page, language: Language, hand: HandName = 'mouse') {
    this.page = page
    this.language = language
    this.painted = new Painted(page)
    this.hand = hand
    this.grip = hand === 'mouse' ? mouse(page) : finger(page)
  }

  /** The words of a message in the child's language. */
  word(key: string, facts: { readonly [name: string]: string | number } = {}): string {
    return message(this.language, key, facts)
  }

  /** What a card is called in the child's language. */
  card(id: string): string {
    return cardMessage(this.language, id)
  }

  // ---- going somewhere ----

  /** Goes home by the link of the page; at home, loads it again. */
  async opensHome() {
    if (await bedsOf(this).isVisible()) await this.page.reload()
    await goesHome(this)
    await this.seesTitle()
  }

  /** The link to a card on the home page, in its chapter. */
  findsCard(card: string): Promise<Locator> {
    return findsCard(this, card)
  }

  /** Opens a card or the free lab from the home page by clicks, and waits for the blocks. */
  async opensLab(card: string) {
    await (card === 'free' ? opensFreeLab(this) : opensCard(this, card))
    await this.seesLab()
  }

  /** For tests of links, reloads and first loads: a card or the free lab by its address. */
  async opensLabByAddress(card: string) {
    // By address: each test that calls this gives a reason.
    await this.page.goto(`/lab/${card}`)
    await this.seesLab()
  }

  async reloads() {
    await this.page.reload()
    await this.seesLab()
  }

  async speaks(language: Language) {
    const name = { de: 'Deutsch', en: 'English' }[language]
    await this.press(this.page.getByRole('button', { name, exact: true }))
    this.language = language
  }

  // ---- pressing ----

  /** Presses something by mouse or by finger. */
  press(thing: Locator): Promise<void> {
    return this.hand === 'mouse' ? thing.click() : thing.tap()
  }

  button(key: string, facts = {}): Locator {
    return this.page.getByRole('button', { name: this.word(key, facts), exact: true })
  }

  async presses(key: string, facts = {}) {
    await this.press(this.button(key, facts).first())
  }

  /** Opens the hint. Its panel loads and takes the focus: it would shut a menu that is opened before. */
  async asksHint() {
    await this.presses('lab.hint')
    await expect(this.page.getByRole('region', { name: this.word('lab.hint'), exact: true })).toBeFocused()
  }

  /** The plus of the network that adds neurons to a layer. */
  plus(layer: 'addSensor' | 'addMotor' | 'addOutput'): Locator {
    return this.page
      .getByRole('region', { name: this.word('lab.network'), exact: true })
      .getByRole('button', { name: this.word(`network.${layer}`), exact: true })
  }

  /** The neurons in the menu of an open plus, from the top. */
  get offered(): Locator {
    return this.page.locator('.menu .sheet').getByRole('button')
  }

  /** Adds a neuron by the plus of the network: the one of this name, else the first that is offered. */
  async addsNeuron(layer: 'addSensor' | 'addMotor' | 'addOutput', name?: string) {
    await this.press(this.plus(layer))
    const choice =
      name === undefined
        ? this.offered.first()
        : this.offered.and(this.page.getByRole('button', { name, exact: true }))
    await this.press(choice)
    await expect(this.offered).toHaveCount(0)
  }

  async pressesStart() {
    await this.presses('lab.start')
    await expect(this.button('lab.stop').first()).toBeVisible()
  }

  /** Takes one step of this kind: it is chosen in the menu first. */
  async steps(kind: 'stepBlock' | 'stepNetwork' | 'stepWorld') {
    await this.presses('lab.stepOf')
    await this.press(this.page.locator('.menu .entry', { hasText: this.word(`lab.${kind}`) }))
    await this.presses(`lab.${kind}`)
  }

  async pressesStop() {
    await this.presses('lab.stop')
    await expect(this.button('lab.start').first()).toBeVisible()
  }

  /** Looks at one part of the lab where only one fits on the screen. */
  async turnsTo(pane: 'program' | 'world' | 'networkTab') {
    await this.press(
      this.page
        .getByRole('navigation', { name: this.word('lab.panes') })
        .getByRole('button', { name: this.word(`lab.${pane}`), exact: true }),
    )
  }

  /** Opens a project file from the lab's menu. */
  async opensFile(name: string, text: string) {
    await this.presses('lab.menu')
    const file = { name, mimeType: 'application/json', buffer: Buffer.from(text) }
    await this.page.locator('input[type=file]').setInputFiles(file)
  }

  /** Opens a project file, and waits until the lab shows the project. */
  async opensProject(name: string, text: string) {
    await this.opensFile(`${name}.botgarten.json`, text)
    await expect(this.page.getByRole('heading', { level: 1 })).toHaveText(name)
    await this.seesLab()
  }

  /** Opens a project file on the home page, and waits until the lab shows the project. */
  async opensProjectAtHome(name: string, text: string) {
    await goesHome(this)
    await this.opensFileAtHome(`${name}.botgarten.json`, text)
    await expect(this.page.getByRole('heading', { level: 1 })).toHaveText(name)
    await this.seesLab()
  }

  /** Opens a project file on the home page. */
  async opensFileAtHome(name: string, text: string) {
    const file = { name, mimeType: 'application/json', buffer: Buffer.from(text) }
    await this.page.locator('input[type=file]').setInputFiles(file)
  }

  /** Saves the project from the lab's menu. Returns what stands in the file. */
  async savesFile(): Promise<string> {
    await this.presses('lab.menu')
    return this.takesFile()
  }

  /** Presses what saves a file, where it is offered. */
  async takesFile(): Promise<string> {
    const [download] = await Promise.all([this.page.waitForEvent('download'), this.presses('lab.saveFile')])
    return readFile(await download.path(), 'utf8')
  }

  // ---- knobs ----

  nameOf(neuron: Sensor | Motor): string {
    const label =
      'sensor' in neuron
        ? this.word('neuron.port', { label: this.word(`neuron.${neuron.sensor}`), port: neuron.port })
        : this.word('neuron.motor', { OUTPUTNODE: neuron.motor })
    return this.word('network.name', { label, place: this.word(`network.place.${neuron.place}`) })
  }

  knob(from: Sensor, to: Motor): Locator {
    const name = this.word('network.weight', { from: this.nameOf(from), to: this.nameOf(to) })
    return this.page.getByRole('slider', { name, exact: true })
  }

  get knobs(): Locator {
    const name = new RegExp(this.word('network.weight', { from: '.+', to: '.+' }))
    return this.page.getByRole('slider', { name })
  }

  /** The round button of an output neuron. */
  output(to: Motor): Locator {
    const output = this.word('neuron.motor', { OUTPUTNODE: to.motor })
    return this.page.getByRole('button', { name: this.word('network.showSum', { output }), exact: true })
  }

  /** Takes the knob by hand and goes along the link until the number is right. */
  async dragsKnob(from: Sensor, to: Motor, weight: number) {
    await this.dragsAlong(this.knob(from, to), this.output(to), weight)
  }

  /**
   * Takes any knob by hand, towards the node at the end of its link, in one grip. On a busy machine a movement can reach the page
   * later than the next frame, which misleads the search: it then starts again, without letting the knob go.
   */
  async dragsAlong(knob: Locator, node: Locator, weight: number) {
    // Waits until the layout is stable and nothing covers the knob.
    await knob.hover({ trial: true })
    const [start, end] = [await middleOf(knob), await middleOf(node)]
    const now = async () => Number(await knob.getAttribute('aria-valuenow'))
    const isRight = async () => Math.abs((await now()) - weight) <= 0.005
    const along = (share: number) => ({
      x: start.x + (end.x - start.x) * share,
      y: start.y + (end.y - start.y) * share,
    })
    const all: [number, number] = (await now()) < weight ? [0, 1] : [-4, 0]
    let [low, high] = all
    await this.grip.down(start)
    for (let tries = 0; tries < 42 && !(await isRight()); tries += 1) {
      if (tries % 14 === 0) [low, high] = all
      const share = (low + high) / 2
      await this.grip.move(along(share))
      // The browser hands a finger's movement on with the next frame.
      await this.watches(2)
      if ((await now()) < weight) low = share
      else high = share
    }
    await this.grip.up()
    await expect(knob).toHaveAttribute('aria-valuenow', String(weight))
  }

  /** Goes to the knob and types the number. */
  async typesWeight(from: Sensor, to: Motor, weight: number) {
    await this.knob(from, to).focus()
    for (const key of weight.toLocaleString(this.language)) await this.page.keyboard.press(key)
    await this.page.keyboard.press('Enter')
    await this.seesWeight(from, to, weight)
  }

  async seesWeight(from: Sensor, to: Motor, weight: number) {
    await expect(this.knob(from, to)).toHaveAttribute('aria-valuenow', String(weight))
  }

  // ---- the keyboard ----

  /** Goes on with the Tab key until this has the focus. */
  async tabsTo(thing: Locator) {
    let element = await thing.elementHandle()
    for (let presses = 0; presses < 90; presses += 1) {
      const { here, lost } = await element.evaluate((one) => ({
        here: one === document.activeElement,
        lost: !one.isConnected,
      }))
      if (here) return
      await this.page.keyboard.press('Tab')
      // To look for it by its name at every stop takes longer than all else.
      if (lost || presses % 10 === 9) element = await thing.elementHandle()
    }
    throw new Error(`The Tab key does not lead to ${String(thing)}`)
  }

  async types(...keys: readonly string[]) {
    for (const key of keys) await this.page.keyboard.press(key)
  }

  /** Goes to a button by Tab and presses it. */
  async tabsAndPresses(key: string, facts = {}) {
    await this.tabsTo(this.button(key, facts).first())
    await this.types('Enter')
  }

  // ---- the world ----

  get bo(): Locator {
    return this.page.getByRole('button', { name: this.word('world.robot'), exact: true })
  }

  /** A thing of the world by what it looks like: `block`, `tree`. */
  thing(look: string): Locator {
    const thing = this.word(`world.thing.${look}`)
    const name = new RegExp(`^${this.word('world.at', { thing, x: '\\d+', y: '\\d+' })}$`)
    return this.page.getByRole('button', { name })
  }

  /** Takes a thing and drags it by so many px. */
  async dragsThing(look: string, by: Spot) {
    const from = await middleOf(this.thing(look))
    await this.drags(from, { x: from.x + by.x, y: from.y + by.y })
  }

  middleOf(thing: Locator): Promise<Spot> {
    return middleOf(thing)
  }

  async drags(from: Spot, to: Spot) {
    await this.grip.down(from)
    for (const share of [0.1, 0.4, 0.7, 1])
      await this.grip.move({ x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share })
    await this.grip.up()
  }

  /** Where Bo stands on the floor. */
  boStands(): Promise<string> {
    return this.painted.stands()
  }

  async seesDriving() {
    const before = await this.boStands()
    await expect.poll(() => this.boStands()).not.toBe(before)
  }

  /** Waits until `seconds` of the robot's time have passed since the program's start. */
  async seesSeconds(seconds: number) {
    const tick = () => this.page.evaluate(() => globalThis.botgarten!.view()!.tick)
    await expect.poll(tick).toBeGreaterThan(seconds * TICKS_PER_SECOND)
  }

  /** Looks for as long as it takes the screen to draw thirty times. */
  async seesStanding() {
    const before = await this.boStands()
    await this.watches(30)
    await expect.poll(() => this.boStands()).toBe(before)
  }

  /** Lets the screen draw so many times. A page that is stuck draws no more. */
  async watches(frames: number) {
    await this.page.evaluate(async (left) => {
      for (; left > 0; left -= 1) await new Promise(requestAnimationFrame)
    }, frames)
  }

  // ---- the program ----

  /** Where the blocks lie; the shelf has a canvas of its own. */
  get canvas(): Locator {
    return this.page.locator('.blocklySvg .blocklyBlockCanvas')
  }

  /** A block by its name in the project. */
  block(id: string): Locator {
    return this.canvas.locator(`[data-id="${id}"]`)
  }

  /** Taps the number in a number block and types another. */
  async typesNumber(block: string, number: string) {
    await this.press(this.block(block).locator('.blocklyNumberField'))
    await this.page.keyboard.press('ControlOrMeta+a')
    await this.types(...number, 'Enter')
  }

  /** All that is written on the blocks, by the alphabet: Blockly draws last what was chosen last. */
  async blockWords(): Promise<string[]> {
    await this.seesBlocks()
    const words = await this.canvas.locator('text').allTextContents()
    return words.map((word) => word.replaceAll('\u00a0', ' ')).toSorted()
  }

  // ---- seeing ----

  /** Words of the screen, wherever they stand. */
  words(key: string, facts = {}): Locator {
    return this.page.getByText(this.word(key, facts), { exact: true })
  }

  dialog(title: string, facts = {}): Locator {
    return this.page.getByRole('dialog', { name: this.word(title, facts) })
  }

  async seesTitle() {
    await expect(this.page.getByRole('heading', { level: 1 })).toBeVisible()
  }

  /** The lab stands. On a phone the blocks are a page of their own. */
  async seesLab() {
    // Where Bo has learned a way already, the first button says what it starts.
    const begins = this.button('lab.start')
      .or(this.button('q.play'))
      .or(this.button('q.letDrive'))
      .or(this.button('q.playNew'))
    await expect(begins.first()).toBeVisible({ timeout: 30_000 })
    if ((this.page.viewportSize()?.width ?? 0) >= 640) await this.seesBlocks()
  }

  /** A program that learns by trying may be folded beside its map: its blocks are there all the same. */
  async seesBlocks() {
    const block = this.canvas.locator('.blocklyDraggable').first()
    await expect(block).toBeAttached()
    if (!(await this.page.locator('section.folded').isVisible())) await expect(block).toBeVisible()
  }

  check(card: string, id: string): Locator {
    return this.page.getByRole('listitem').filter({ hasText: checkMessage(this.language, card, id) })
  }

  async seesCheck(card: string, id: string, passed = true, timeout = 40_000) {
    const said = this.word(passed ? 'lab.goalPassed' : 'lab.goalOpen')
    await expect(this.check(card, id)).toContainText(said, { timeout })
  }

  async seesSaved() {
    await expect(this.page.getByRole('status').filter({ hasText: this.word('lab.saved') })).toBeVisible()
  }
}
