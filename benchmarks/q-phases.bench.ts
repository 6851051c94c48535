import type { Browser, Page } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { Learner } from '../e2e/child-learning.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { median, type Table } from './bench.ts'
import { freshChild } from './slow.ts'

const phases = ['here', 'decide', 'ride', 'reward', 'learn'] as const
type Phase = (typeof phases)[number]
const speeds = [1, 2, 3] as const
const moves = 8

const shows: { readonly [phase in Phase]: string } = {
  here: 'where Bo is',
  decide: 'the decision, and the dice that made it',
  ride: 'the ride, and where it leads',
  reward: 'what the move pays',
  learn: 'the number that changes',
}

interface Change {
  readonly phase: string
  readonly at: number
}

/** Every phase as the page comes to it, until enough moves were played. */
function watch(page: Page): Promise<readonly Change[]> {
  return page.locator('svg[data-phase]').evaluate(
    (map, wanted) =>
      new Promise<Change[]>((done) => {
        const changes: Change[] = []
        const watcher = new MutationObserver(() => {
          changes.push({ phase: map.getAttribute('data-phase') ?? '', at: performance.now() })
          if (changes.length < wanted) return
          watcher.disconnect()
          done(changes)
        })
        watcher.observe(map, { attributes: true, attributeFilter: ['data-phase'] })
      }),
    moves * phases.length + 1,
  )
}

async function timesAt(browser: Browser, url: string, speed: number): Promise<readonly Change[]> {
  const child = await freshChild(browser, url)
  const learner = new Learner(child)
  await learner.opens('railway')
  await child.presses('q.times', { speed })
  const watching = watch(child.page)
  await child.presses('q.play')
  const changes = await watching
  await child.page.context().close()
  return changes
}

const ms = (value: number) => `${value.toFixed(0)} ms`

/** Milliseconds that each phase was the one that is shown. */
function durations(changes: readonly Change[], phase: Phase): number {
  const own = changes
    .slice(0, -1)
    .flatMap((change, index) => (change.phase === phase ? [changes[index + 1]!.at - change.at] : []))
  return median(own)
}

/** How long a child sees each phase of a move. */
export default async function qPhases(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  const seen: (readonly Change[])[] = []
  for (const speed of speeds) seen.push(await timesAt(browser, server.url, speed))
  await browser.close()
  await server.close()
  return {
    title: 'Phases of a move',
    how: `Chromium. The card Railway is played at ×1, ×2 and ×3; for ${moves} moves each change of the phase on the map is noted with its time. Middle values.`,
    columns: ['phase', 'what it shows', ...speeds.map((speed) => `×${speed}`), 'stays to be read at ×1'],
    rows: [
      ...phases.map((phase) => [
        phase,
        shows[phase],
        ...seen.map((changes) => ms(durations(changes, phase))),
        '1000 ms',
      ]),
      ['', 'whole move', ...seen.map((changes) => ms(wholeMove(changes))), ''],
    ],
    notes: [
      'What a phase shows stays on the screen until the next move comes to the same phase: at ×1 a second each. A single step and a pause leave all of it there for as long as one likes.',
      'With reduced motion the times are the same; Bo is at one end of the road or at the other.',
    ],
  }
}

function wholeMove(changes: readonly Change[]): number {
  const begins = changes.filter(({ phase }) => phase === 'decide').map(({ at }) => at)
  return median(begins.slice(1).map((at, index) => at - begins[index]!))
}
