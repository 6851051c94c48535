import { readFileSync } from 'node:fs'
import { readFile } from 'node:fs/promises'
import { expect, type Locator } from '@playwright/test'
import { cardProject, readCard, type CardProgram, type WorldFile } from '@botgarten/content'
import { mapField } from '@botgarten/blocks'
import type { Child } from './child.ts'
import { fixesDice, goesHome } from './navigation.ts'

/** What a child does and sees in the playground for learning by trying. */
export class Learner {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }

  /** With fixed dice: what is learned is the same every time. */
  async opens(card: 'mars' | 'railway' | 'forest' | 'city') {
    await goesHome(this.child)
    await fixesDice(this.child)
    await this.child.opensLab(card)
    await this.sees()
  }

  /** The same with a project file. */
  async opensProject(name: string, text: string) {
    await goesHome(this.child)
    await fixesDice(this.child)
    await this.child.opensProjectAtHome(name, text)
    await this.sees()
  }

  async sees() {
    await expect(this.child.page.getByRole('group', { name: this.child.word('q.map') })).toBeVisible()
  }

  /** The button that learns; with all the room it is the one that starts all. */
  async learns() {
    const { child } = this
    const wide = await child.page.locator('.q.room').isVisible()
    await child.presses(wide ? 'lab.start' : 'q.play')
  }

  /** Opens the program over the map. */
  async unfolds() {
    await this.child.presses('lab.unfold')
    await this.child.seesBlocks()
  }

  /** Taps a way on the map, from the start on. */
  async guesses(...stations: readonly number[]) {
    await this.child.presses('q.guessing.open')
    for (const station of stations) await this.child.press(this.station(station))
  }

  station(station: number): Locator {
    return this.child.button('q.station', { station })
  }

  /** What the roads of a station are worth. */
  row(station: number): Locator {
    return this.child.page.locator('.drawer tbody tr').nth(station)
  }

  road(from: number, to: number): Locator {
    return this.child.button('q.road', { from, to })
  }

  /** Taps a road on the map, and what is to become of it. */
  async closes(from: number, to: number, how: 'closeRoad' | 'openRoad' = 'closeRoad') {
    await this.child.press(this.road(from, to))
    await this.child.presses(`q.${how}`)
  }

  async makesStation(station: number, what: 'startHere' | 'goalHere') {
    await this.child.press(this.station(station))
    await this.child.presses(`q.${what}`)
  }

  /** As fast as it goes. */
  async hurries() {
    await this.child.presses('q.turbo')
  }

  /** As fast as it goes, until a limit stops it. */
  async learnsToTheEnd() {
    await this.hurries()
    await this.learns()
    await this.seesEnd()
    if (!(await this.child.page.locator('.best ol, .room .way').isVisible())) return
    // Bo drives what it has learned, and the floor has come forward.
    await expect(this.floor).toBeVisible()
    await this.child.presses('q.largeMap')
  }

  /** A limit has stopped the learning: it can start again, or Bo is already driving. */
  async seesEnd() {
    const { child } = this
    await expect(child.button('q.playNew').or(this.floor)).toBeVisible()
  }

  /** Where Bo drives what it has learned. */
  get floor(): Locator {
    return this.child.page.getByRole('region', { name: this.child.word('q.drives') })
  }

  /** Another map, by its name. */
  async choosesMap(name: string) {
    const { child } = this
    await child.presses('q.change')
    const maps = child.page.getByRole('combobox', { name: child.word('q.page.map'), exact: true })
    await maps.selectOption({ label: name })
    // The choice is not on the page, and hears no key, while the map is loaded.
    await expect(async () => {
      await child.types('Escape')
      await expect(maps).toBeHidden({ timeout: 500 })
      await this.sees()
      await expect(maps).toBeHidden({ timeout: 500 })
    }).toPass()
  }

  /** Another map, in the field of the block; both by their ids. The program stays open. */
  async choosesMapInBlock(from: string, to: string) {
    const { child } = this
    const name = (map: string) => child.word(`choice.${mapField(map)}`)
    await this.unfolds()
    await child.press(child.page.locator('.blocklyDropdownField', { hasText: name(from) }))
    await child.press(child.page.locator('.blocklyDropDownDiv .blocklyMenuItem', { hasText: name(to) }))
  }

  /** More tries, and more time for them, typed over the numbers of now in the block that says so. */
  async givesTries(tries: number, time: number, now = { tries: 10, time: 10_000 }) {
    const { child } = this
    await this.unfolds()
    const fields = child.block('experience').locator('.blocklyInputField')
    for (const [before, after] of [
      [now.tries, tries],
      [now.time, time],
    ]) {
      await this.child.press(fields.filter({ hasText: new RegExp(`^\\s*${before}\\s*$`) }))
      await child.types('ControlOrMeta+a', ...String(after), 'Enter')
    }
    await child.presses('lab.fold')
  }

  /** Stations of the best way. */
  async way(): Promise<readonly number[]> {
    const texts = await this.wayStations.allTextContents()
    return texts.map(Number)
  }

  get wayStations(): Locator {
    return this.child.page.locator('.best ol b, .line .way b')
  }

  async seesWay(...stations: readonly number[]) {
    await expect(this.wayStations).toHaveText(stations.map(String))
  }

  /** Map, numbers under their heads, and the table (or the row of the move) are seen together, nothing of them cut. */
  async seesAllTogether(rows: 'all' | 'now') {
    const { page } = this.child
    const heads = await page.locator('.statistics dt').all()
    const table = page.locator('.drawer tbody tr')
    const seen = rows === 'all' ? await table.all() : [table.filter({ has: page.locator('button.now') })]
    for (const part of [page.locator('.space .frame'), ...heads, ...seen])
      await expect(part).toBeInViewport({ ratio: 0.99 })
  }

  /** The move that is shown, and how far it has come. */
  async moves(): Promise<{ shown: number; made: number }> {
    const time = this.timeline
    const [shown, made] = [await time.inputValue(), await time.getAttribute('max')]
    return { shown: Number(shown), made: Number(made) }
  }

  get timeline(): Locator {
    return this.child.page.getByRole('slider', { name: this.child.word('q.timeline'), exact: true })
  }

  async turnsTo(page: 'map' | 'inside' | 'curves' | 'trials') {
    // Where the map stands beside it always, there is no page for it.
    if (page === 'map' && (await this.child.page.locator('.q.room').isVisible())) return
    // The card of the lab is called like the map in German.
    const pages = this.child.page.getByRole('group', { name: this.child.word('q.pages'), exact: true })
    await this.child.press(
      pages.getByRole('button', { name: this.child.word(`q.page.${page}`), exact: true }),
    )
  }

  /** How much of the covers of roads can be seen, 0..1; of some roads: `5-7|6-7`. */
  async covers(roads = '.*'): Promise<number[]> {
    const covers = await this.child.page
      .locator('[id^=cover-]')
      .evaluateAll((all) =>
        all.map((cover) => [cover.id, Number(cover.getAttribute('fill-opacity'))] as const),
      )
    const wanted = new RegExp(`^cover-(${roads})$`)
    return covers.filter(([id]) => wanted.test(id)).map(([, opacity]) => opacity)
  }

  /** Listens like a reader. Gives all sentences so far. */
  async listens(): Promise<() => Promise<string[]>> {
    const heard = await this.child.page.locator('.q > [aria-live]').evaluateHandle((live) => {
      const sentences: string[] = []
      const note = () => live.textContent && sentences.push(live.textContent)
      new MutationObserver(note).observe(live, { childList: true, characterData: true, subtree: true })
      return sentences
    })
    return () => heard.evaluate((sentences) => [...sentences])
  }

  /** Where Bo is seen on the map, frame by frame, for some milliseconds. */
  async places(milliseconds: number): Promise<ReadonlySet<string>> {
    const seen = await this.child.page.locator('.space .bo').evaluate(async (bo, time) => {
      const places = new Set<string>()
      const end = performance.now() + time
      while (performance.now() < end) {
        places.add((bo as SVGElement).style.transform)
        await new Promise(requestAnimationFrame)
      }
      return [...places]
    }, milliseconds)
    return new Set(seen)
  }

  /** Saves the table of runs. Returns what stands in the file. */
  async savesTable(): Promise<string> {
    const { page } = this.child
    const [download] = await Promise.all([page.waitForEvent('download'), this.child.presses('q.csv')])
    return readFile(await download.path(), 'utf8')
  }

  /** So many rows of the block close a road: each says "from", and so does the map once. */
  async seesClosedRoads(count: number) {
    const from = this.child.word('block.ai_q_barrier_mountain.row0').split(' ')[0]!
    const rows = async () => (await this.child.blockWords()).filter((word) => word === from).length - 1
    await expect.poll(rows).toBe(count)
  }
}

/** The railway's card as a project file, with other fields of its map block, and so many tries. */
export function learningProject(
  name: string,
  fields: { readonly [name: string]: string },
  tries = 300,
): string {
  const read = (path: string): unknown =>
    JSON.parse(readFileSync(new URL(`../content/${path}`, import.meta.url), 'utf8'))
  const text = JSON.stringify(read('cards/q-learning/01-railway/start.json'), (key, value: unknown) =>
    key === 'fields' && typeof value === 'object' && value && 'FINISH' in value
      ? { ...value, ...fields }
      : value,
  ).replace('"EPISODES":"10"', `"EPISODES":"${tries}"`)
  const world = read('worlds/learning/world.json') as WorldFile
  const card = readCard(read('cards/q-learning/01-railway/card.json'))
  return JSON.stringify(cardProject(world, card, JSON.parse(text) as CardProgram, name))
}
