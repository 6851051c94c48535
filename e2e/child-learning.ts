import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'

/** What a child does and sees in the playground for learning by trying. */
export class Learner {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }

  async opens(card: 'railway' | 'forest' | 'city') {
    await this.child.opensLab(card)
    await this.sees()
  }

  async sees() {
    await expect(this.child.button('q.play').or(this.child.button('q.playNew'))).toBeVisible()
  }

  station(station: number): Locator {
    return this.child.button('q.station', { station })
  }

  road(from: number, to: number): Locator {
    return this.child.button('q.road', { from, to })
  }

  /** Taps a road on the map, and what is to become of it. */
  async closes(from: number, to: number, how: 'closeRoad' | 'openRoad' = 'closeRoad') {
    await this.road(from, to).click()
    await this.child.presses(`q.${how}`)
  }

  async makesStation(station: number, what: 'startHere' | 'goalHere') {
    await this.station(station).click()
    await this.child.presses(`q.${what}`)
  }

  /** As fast as it goes. */
  async hurries() {
    await this.child.presses('q.turbo')
  }

  async seesWay(...stations: readonly number[]) {
    const line = this.child.page.locator('.way').filter({ hasText: this.child.word('q.bestWay') })
    await expect(line.locator('b')).toHaveText(stations.map(String))
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
    await this.child.presses(`q.page.${page}`)
  }

  /** So many rows of the block close a road: each says "from", and so does the map once. */
  async seesClosedRoads(count: number) {
    const from = this.child.word('block.ai_q_barrier_mountain.row0').split(' ')[0]!
    const rows = async () => (await this.child.blockWords()).filter((word) => word === from).length - 1
    await expect.poll(rows).toBe(count)
  }
}
