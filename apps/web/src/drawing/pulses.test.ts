import { expect, test } from 'vitest'
import { Pulses } from './pulses.ts'
import { freeLine, pulseRate } from './track.ts'

const track = freeLine({ x: 0, y: 0 }, { x: 300, y: 0 }, 40)
const link = (signal: number) => [{ id: 'a→b', track, signal }]

test('a signal of 50 is under way for 900 ms (the playground’s rule)', () => {
  const pulses = new Pulses()
  let share = pulses.at(1000, link(50))[0]!.share
  let passed = 0
  for (let now = 1010; passed < 1 && now < 3000; now += 10) {
    const next = pulses.at(now, link(50))[0]!.share
    passed += (next - share + 1) % 1
    share = next
  }
  expect(passed).toBeCloseTo(1, 1)
  expect(pulseRate(50).milliseconds).toBe(900)
})

test('a stronger signal is faster from where it is, and after a pause pulses go on from there too', () => {
  const pulses = new Pulses()
  pulses.at(0, link(10))
  const before = pulses.at(50, link(10))[0]!.share
  const [after] = pulses.at(60, link(100))
  expect(after!.share - before).toBeCloseTo(10 / 500)
  expect(after!.count).toBe(8)
  expect(pulses.at(60_000, link(100))[0]!.share).toBe(after!.share)
})

test('nothing is under way where nothing is signalled', () => {
  expect(new Pulses().at(0, link(0))[0]!.count).toBe(0)
})
