import { content } from '@botgarten/content/files'
import type { World } from '@botgarten/simulation'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { mendedCages, notedOf } from './notes.ts'
import type { Order, Report, Seen } from './messages.ts'
import { SenseWork } from './sense-work.svelte.ts'

const loaded = content.senseCages[0]!
const { cage, rows } = loaded

/** A worker that only records its requests; the test sends the answers. */
class Asked {
  static orders: Order[] = []
  static last: Asked
  static ended = 0
  onmessage: ((event: { readonly data: Report }) => void) | null = null
  onerror: (() => void) | null = null
  constructor() {
    Asked.last = this
  }
  postMessage(order: Order): void {
    Asked.orders.push(order)
  }
  terminate(): void {
    Asked.ended += 1
  }
}

let work: SenseWork
beforeEach(() => {
  freshLocalStorage()
  screen()
  Object.assign(Asked, { orders: [], ended: 0 })
  vi.stubGlobal('Worker', Asked)
  work = newWork()
})
afterEach(() => {
  work.close()
  vi.unstubAllGlobals()
})

const newWork = () => new SenseWork(loaded, { worlds: [{} as World], picture: null })
const orders = () => Asked.orders.map(({ kind }) => kind)
const learnOrders = () => Asked.orders.filter((order) => order.kind === 'learn')
const answers = (report: Report) => Asked.last.onmessage!({ data: report })
/** A drive with the cage's own pay, with the fields that the model reads. */
const seen = (minute: number | null): Seen =>
  ({ table: { pay: cage.trial.pay }, minute, watched: [] }) as unknown as Seen

describe('a cage of sensors', () => {
  test('is watched only after a guess, with the table that was learned before', () => {
    work.watch()
    expect(orders()).toEqual([])
    work.guessThat('cheats')
    work.watch()
    expect(orders()).toEqual(['open', 'watch'])
    expect([work.busy, work.seen]).toEqual([true, null])
    answers({ kind: 'seen', seen: seen(null) })
    expect([work.busy, work.isCagePay, work.isNow, work.mended]).toEqual([false, true, true, false])
    expect(notedOf(cage.id)).toEqual({ guess: 'cheats', watched: true, mended: false })
  })

  test('is guessed before it is watched, not afterwards', () => {
    work.guessThat('cheats')
    work.guessThat('honest')
    work.watch()
    answers({ kind: 'seen', seen: seen(null) })
    work.guessThat('other')
    expect([work.guess, newWork().guess]).toEqual(['honest', 'honest'])
  })

  test('is fixed once the robot was good for a while, and stays so', () => {
    expect(mendedCages()).toBe(0)
    work.guessThat('cheats')
    work.learn()
    answers({ kind: 'minute', minute: 3 })
    expect([work.minute, work.busy]).toEqual([3, true])
    answers({ kind: 'seen', seen: seen(5) })
    expect([work.minute, work.busy, work.mended]).toEqual([null, false, true])
    work.learn()
    answers({ kind: 'seen', seen: seen(null) })
    expect([work.mended, mendedCages(), newWork().mended]).toEqual([true, 1, true])
  })

  test('shows the robot of its own row first', () => {
    const first = rows.bos.find(({ seed }) => seed === rows.shown.seed)!
    expect([work.shownCheats, work.seed]).toEqual([first.cheats, rows.shown.seed])
  })
})

describe('the pay', () => {
  test('is shown in coins for what a pupil counts, and sent in the units of the learner', () => {
    work.learn()
    expect(learnOrders()[0]!.pay).toEqual(cage.trial.pay)
    expect(work.pay.map((one) => one.for)).toEqual(cage.trial.pay.map((one) => one.for))
  })

  test('can be changed, added to, taken from, and put back', () => {
    const before = work.pay
    work.setCoins(0, 3)
    work.setKind(0, 'bump')
    expect(work.pay[0]).toEqual({ for: 'bump', coins: 3 })
    expect(work.pay.slice(1)).toEqual(before.slice(1))
    work.add()
    expect(work.pay.at(-1)).toEqual({ for: 'bump', coins: -5 })
    work.remove(0)
    expect(work.pay).toEqual([...before.slice(1), { for: 'bump', coins: -5 }])
    work.restore()
    expect(work.pay).toEqual(before)
  })

  test('is at most 20 coins, and what is no number changes nothing', () => {
    for (const [coins, wanted] of [
      [50, 20],
      [-50, -20],
      [NaN, -20],
      [Infinity, -20],
    ] as const) {
      work.setCoins(0, coins)
      expect(work.pay[0]!.coins).toBe(wanted)
    }
  })

  test('has no more sentences than the learner takes', () => {
    while (!work.isFull) work.add()
    const { length } = work.pay
    work.add()
    expect(work.pay).toHaveLength(length)
  })

  test('without a sentence has a problem: nothing can be learned with it', () => {
    while (work.pay.length > 0) work.remove(0)
    expect(work.problem).not.toBeNull()
    work.learn()
    expect(orders()).toEqual([])
  })

  test('that was learned with is told apart from the one of now', () => {
    work.guessThat('cheats')
    work.watch()
    expect([work.isNow, work.isCagePay]).toEqual([false, false])
    answers({ kind: 'seen', seen: seen(null) })
    work.setCoins(0, 7)
    expect([work.isNow, work.isCagePay]).toEqual([false, true])
  })

  test('ends the drive that was learned with the pay of before', () => {
    work.guessThat('cheats')
    work.watch()
    const poses = Array.from({ length: 600 }, () => ({ x: 0, y: 0, heading: 0 }))
    answers({ kind: 'seen', seen: { ...seen(null), watched: [{ poses, coins: [], posesAMove: 60 }] } })
    expect(work.player.playing).toBe(true)
    work.setCoins(0, work.pay[0]!.coins)
    expect(work.player.playing).toBe(true)
    work.setCoins(0, 7)
    expect(work.player.playing).toBe(false)
  })
})

describe('learning', () => {
  test('with the same pay again is done by another robot, with another pay by the first one', () => {
    const { seed } = rows.shown
    for (const coins of [7, 7, 7, 8]) {
      work.setCoins(0, coins)
      work.learn()
      answers({ kind: 'seen', seen: seen(null) })
    }
    expect(learnOrders().map((order) => order.seed)).toEqual([seed, seed + 1, seed + 2, seed])
  })

  test('does not begin twice at once', () => {
    work.learn()
    work.learn()
    expect(learnOrders()).toHaveLength(1)
  })

  test('that is stopped ends its worker; the next one opens the cage again', () => {
    work.learn()
    work.stop()
    expect([Asked.ended, work.busy, work.minute]).toEqual([1, false, null])
    work.learn()
    expect(orders()).toEqual(['open', 'learn', 'open', 'learn'])
  })

  test('that fails shows a message until the next one', () => {
    work.learn()
    Asked.last.onerror!()
    expect([work.failed, work.busy]).toEqual([true, false])
    work.learn()
    expect(work.failed).toBe(false)
  })
})
