import fc from 'fast-check'
import { draw, stream } from '@botgarten/numbers'
import { isLong } from '@botgarten/numbers/testing'
import { expect, test } from 'vitest'
import { Refusal } from '../refusal.ts'
import { Guesses, type Trier } from './guesses.ts'
import { networkOf } from './network.ts'

/** A node with a clock that is set by hand. */
function nodeWith(pace: { atOnce: number; eachSecond: number }) {
  const clock = { now: 0 }
  return { clock, guesses: new Guesses(() => clock.now, pace) }
}

const address = (name: string): Trier => ({ key: name, pace: { atOnce: 60, eachSecond: 0.2 } })

/** Tries something wrong. @returns the seconds to wait after it; null if it was not even tried */
function tryWrong(guesses: Guesses, ...triers: Trier[]): number | null {
  try {
    return guesses.begin(triers).wrong()
  } catch (error) {
    if (!(error instanceof Refusal) || error.status !== 429) throw error
    if (!(Number(error.facts['seconds']) >= 1))
      throw new Error('A refusal names no seconds.', { cause: error })
    return null
  }
}

/** Tries something right. */
function passes(guesses: Guesses, ...triers: Trier[]): boolean {
  try {
    guesses.begin(triers).right()
    return true
  } catch {
    return false
  }
}

test('property: a node answers no more wrong tries than its pace', () => {
  fc.assert(
    fc.property(
      fc.integer({ min: 1, max: 50 }),
      fc.array(fc.tuple(fc.nat(3000), fc.nat(60), fc.nat(5)), { maxLength: 40 }),
      (eachSecond, steps) => {
        const { clock, guesses } = nodeWith({ atOnce: 100, eachSecond })
        let answered = 0
        for (const [pause, tries, from] of steps) {
          clock.now += pause
          for (let count = 0; count < tries; count++)
            if (tryWrong(guesses, address(`${from}`)) !== null) answered++
        }
        expect(answered).toBeLessThanOrEqual(100 + (clock.now / 1000) * eachSecond)
      },
    ),
  )
})

test('a thousand addresses that try as fast as they can leave room for an address that has tried nothing', () => {
  const { clock, guesses } = nodeWith({ atOnce: 1500, eachSecond: 289 })
  let refused = 0
  for (let second = 0; second < 120; second++) {
    clock.now += 1000
    for (let from = 0; from < 1000; from++) if (tryWrong(guesses, address(`${from}`)) === null) refused++
    expect(passes(guesses, address(`school of second ${second}`))).toBe(true)
    // Once each attacker has been wrong a few times, a school where a child mistypes now and then still comes first.
    if (second >= 60) expect(passes(guesses, address('school'))).toBe(true)
    if (second >= 60 && second % 5 === 0) expect(tryWrong(guesses, address('school'))).toBe(0)
  }
  // 120,000 tries less the 1,500 and 289 a second that are answered.
  expect(refused).toBeGreaterThanOrEqual(120_000 - 1500 - 120 * 289)
})

test('in a school day of 8 hours a thousand addresses find the code of one class with less than 0.01 %', () => {
  const { clock, guesses } = nodeWith({ atOnce: 1500, eachSecond: 289 })
  const chance = stream(1, 'school day')
  // 5 minutes of them in `npm test`. The attacker sends 400 a second, more than are answered.
  const seconds = isLong ? 8 * 3600 : 300
  let answered = 0
  for (let second = 0; second < seconds; second++) {
    clock.now += 1000
    for (let tries = 0; tries < 400; tries++)
      if (tryWrong(guesses, address(`${Math.floor(draw(chance) * 1000)}`)) !== null) answered++
  }
  const aDay = (answered / seconds) * 8 * 3600
  expect(answered / seconds).toBeGreaterThan(100)
  expect(aDay / (1024 * 1023 * 1022 * 1021)).toBeLessThan(0.0001)
})

test('after 60 wrong tries an address waits 5 s for the next, longer for each one more, and at most 30 s', () => {
  const { guesses } = nodeWith({ atOnce: 1500, eachSecond: 289 })
  const waits = Array.from({ length: 70 }, () => tryWrong(guesses, address('one')))
  expect(waits.slice(0, 60)).toEqual(Array(60).fill(0))
  // One more each 5 s: 0.2 a second.
  expect(waits.slice(60)).toEqual([5, 10, 15, 20, 25, 30, 30, 30, 30, 30])
  expect(tryWrong(guesses, address('other'))).toBe(0)
})

test('what waits is not tried at all beyond its pace, and is free again with time', () => {
  const { clock, guesses } = nodeWith({ atOnce: 1500, eachSecond: 289 })
  const account: Trier = { key: 'account', pace: { atOnce: 10, eachSecond: 1 / 15 }, waits: true }
  for (let count = 0; count < 10; count++) expect(tryWrong(guesses, account)).toBe(0)
  expect(passes(guesses, account)).toBe(false)
  clock.now += 15_001
  expect(passes(guesses, account)).toBe(true)
})

test('a right try does not count', () => {
  const { guesses } = nodeWith({ atOnce: 10, eachSecond: 1 })
  for (let count = 0; count < 1000; count++) expect(passes(guesses, address('one'))).toBe(true)
  expect(tryWrong(guesses, address('one'))).toBe(0)
})

test('an attacker with a new cookie for each try makes the node forget neither its address nor run out of memory', () => {
  const { clock, guesses } = nodeWith({ atOnce: 1500, eachSecond: 289 })
  for (let count = 0; count < 60_000; count++) {
    clock.now += 5
    tryWrong(guesses, address('attacker'), { key: `cookie ${count}`, pace: { atOnce: 20, eachSecond: 0.03 } })
  }
  expect(guesses.size).toBeLessThanOrEqual(50_000)
  expect(tryWrong(guesses, address('attacker'))).toBe(30)
})

test.each([
  ['192.0.2.7', '192.0.2.7'],
  ['2001:db8:1:2:3:4:5:6', '2001:db8:1:2::/64'],
  ['2001:0DB8:0001:0002::9', '2001:db8:1:2::/64'],
  ['2001:db8::1', '2001:db8:0:0::/64'],
  ['::1', '0:0:0:0::/64'],
  ['fe80::1%eth0', 'fe80::1'],
  ['fe80::2', 'fe80::2'],
])('wrong tries from %s are counted under %s', (given, network) => expect(networkOf(given)).toBe(network))
