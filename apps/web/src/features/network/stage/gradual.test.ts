import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { Gradual, many } from './gradual.svelte.ts'

let draw: ReturnType<typeof screen>
let gradual: Gradual<number>
beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  draw = screen()
  gradual = new Gradual((one) => one)
})
afterEach(() => {
  gradual.stop()
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

const numbers = (count: number, from = 0) => Array.from({ length: count }, (_, k) => from + k)

describe('a list of 60', () => {
  test('is there at once, and so is the next one', () => {
    gradual.follow(numbers(many), false)
    expect(gradual.list).toHaveLength(60)
    gradual.follow(numbers(3, 100), false)
    expect(gradual.list).toEqual([100, 101, 102])
  })
})

describe('a longer list', () => {
  test('comes six a frame from the beginning, until all are there', () => {
    gradual.follow(numbers(61), false)
    const lengths = [gradual.list.length]
    for (let frame = 0; frame < 12; frame += 1) {
      draw()
      lengths.push(gradual.list.length)
    }
    expect(lengths).toEqual([6, 12, 18, 24, 30, 36, 42, 48, 54, 60, 61, 61, 61])
  })

  test('waits for 400 ms without another one, where something is there', () => {
    gradual.follow(numbers(10), true)
    gradual.follow(numbers(70), false)
    vi.advanceTimersByTime(399)
    draw()
    expect(gradual.list).toHaveLength(10)
    vi.advanceTimersByTime(1)
    expect(gradual.list).toHaveLength(16)
  })

  test('waits for nothing where the user waits for it', () => {
    gradual.follow(numbers(10), true)
    gradual.follow(numbers(70), true)
    expect(gradual.list).toHaveLength(16)
  })

  test('that is panned goes on once it rests; one that is complete does not begin', () => {
    gradual.follow(numbers(70), true)
    gradual.wait()
    draw()
    expect(gradual.list).toHaveLength(6)
    vi.advanceTimersByTime(300)
    gradual.wait()
    vi.advanceTimersByTime(399)
    expect(gradual.list).toHaveLength(6)
    vi.advanceTimersByTime(1)
    expect(gradual.list).toHaveLength(12)
    for (let frame = 0; frame < 12; frame += 1) draw()
    expect(gradual.list).toHaveLength(70)
    gradual.wait()
    expect(vi.getTimerCount()).toBe(0)
  })

  test('that is stopped stays as it is', () => {
    gradual.follow(numbers(70), true)
    gradual.stop()
    draw()
    expect(gradual.list).toHaveLength(6)
  })
})

test('what is there is renewed at once, although others come later', () => {
  interface Knob {
    readonly key: number
    readonly at: number
  }
  const knobs = new Gradual<Knob>(({ key }) => key)
  const at = (place: number, count: number) => numbers(count).map((key) => ({ key, at: place }))
  knobs.follow(at(0, 2), false)
  knobs.follow(at(9, 70), false)
  expect(knobs.list).toEqual(at(9, 2))
  knobs.stop()
})

test('where nothing is on its way waiting begins nothing', () => {
  gradual.wait()
  expect(vi.getTimerCount()).toBe(0)
  gradual.follow(numbers(10), true)
  gradual.follow(numbers(70), false)
  gradual.stop()
  gradual.wait()
  expect(vi.getTimerCount()).toBe(0)
})
