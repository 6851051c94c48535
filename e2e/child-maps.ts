import { expect, type Locator } from '@playwright/test'
import { Learner } from './child-learning.ts'
import type { Child } from './child.ts'
import type { Spot } from './hand.ts'

/** Of the map that is made. */
const stations = 3
const roads = [
  [0, 1],
  [1, 2],
] as const

/** What a child does in the designer of maps. */
export class MapMaker {
  readonly child: Child
  readonly #learner: Learner

  constructor(child: Child) {
    this.child = child
    this.#learner = new Learner(child)
  }

  /** From home on to empty paper. */
  async begins(press: (thing: Locator) => Promise<void>) {
    const { child } = this
    await child.opensHome()
    await press(child.page.getByRole('link', { name: child.word('home.maps'), exact: true }))
    await press(child.button('design.new'))
  }

  /** Three stations and two roads, with the list beside the map. */
  async lists(press: (thing: Locator) => Promise<void>) {
    const { child } = this
    await press(child.button('design.asList'))
    for (let count = 0; count < stations; count += 1) await press(child.button('design.addStation'))
    for (const [from, to] of roads) {
      await this.#chooses('design.from', from)
      await this.#chooses('design.to', to)
      await press(child.button('design.addRoad'))
    }
    await press(child.button('design.asAnswers'))
  }

  /** Three stations and two roads by the mouse on empty paper; the last station is the goal, and Bo has tried both roads. */
  async draws() {
    const { page } = this.child
    const places = [await this.place(0.15, 0.7), await this.place(0.5, 0.25), await this.place(0.85, 0.7)]
    for (const { x, y } of places) await page.mouse.click(x, y)
    await expect(this.station(stations - 1)).toBeVisible()
    await this.child.presses('design.tool.road')
    for (const [from, to] of roads) await this.child.drags(places[from]!, places[to]!)
    await this.station(stations - 1).focus()
    await this.child.presses('design.goalHere')
    await this.seesReached(2)
    await this.seesTried(2, 2)
  }

  /** The tool that a press on the paper uses from now on. */
  async takes(tool: 'station' | 'road' | 'sign' | 'reward', press: (thing: Locator) => Promise<void>) {
    const tools = this.child.page.getByRole('region', { name: this.child.word('design.tools') })
    await press(tools.getByRole('button', { name: this.child.word(`design.tool.${tool}`), exact: true }))
  }

  /** A place on the paper, as shares of its width and height. */
  async place(across: number, down: number): Promise<Spot> {
    const { child } = this
    const paper = child.page.getByRole('group', { name: child.word('design.paper'), exact: true })
    const box = (await paper.boundingBox())!
    return { x: box.x + across * box.width, y: box.y + down * box.height }
  }

  station(station: number): Locator {
    return this.child.button('design.station', { station })
  }

  road(from: number, to: number): Locator {
    return this.child.button('design.road', { from, to })
  }

  async seesTried(count: number, all: number) {
    const said = this.child.word('design.triedCount', { count, all })
    await expect(this.child.page.getByText(said, { exact: true })).toBeVisible()
  }

  /** Types the number of a station into a list. */
  async #chooses(list: 'design.from' | 'design.to', station: number) {
    const { child } = this
    const box = child.page.getByRole('combobox', { name: child.word(list), exact: true })
    await child.tabsTo(box)
    await child.types(String(station))
    await expect(box).toHaveValue(String(station))
  }

  /** A way to the goal over so many roads. */
  async seesReached(goal: number, count = goal) {
    const { child } = this
    const said = child.word('design.reached', { start: 0, goal, count })
    await expect(child.page.getByText(said, { exact: true })).toBeVisible()
  }

  /** On A3. What a printer would be given is looked at on the screen. */
  async prints(press: (thing: Locator) => Promise<void>) {
    const { child } = this
    await child.page.evaluate(() => (window.print = () => (document.title = 'printed')))
    await press(child.button('design.print'))
    await press(child.button('design.paper_a3'))
    await expect(child.page).toHaveTitle('printed')
    await child.page.emulateMedia({ media: 'print' })
    await expect(child.page.locator('.printed-map.a3 img')).toBeVisible()
    await child.page.emulateMedia({ media: 'screen' })
  }

  /** Bo learns on the map, and drives what it has learned. */
  async learnsAndDrives(press: (thing: Locator) => Promise<void>, ...way: readonly number[]) {
    const { child } = this
    await press(child.button('design.learn'))
    await this.#learner.sees()
    await press(child.button('q.turbo'))
    await press(child.button('lab.start').first())
    await this.#learner.seesWay(...way)
    await expect(this.#learner.floor).toBeVisible()
  }
}
