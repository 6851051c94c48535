import { afterEach, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { budgetFor, holdStill, onNextFrame } from './clock.ts'

afterEach(() => vi.unstubAllGlobals())

/** An animation as a document lists it, on an element with this name. */
class Effect {
  readonly target: string
  readonly iterations: number
  constructor(target: string, iterations: number) {
    this.target = target
    this.iterations = iterations
  }
  getTiming = () => ({ iterations: this.iterations })
}
const animation = (target: string, iterations: number) => {
  const made = {
    effect: new Effect(target, iterations),
    playState: 'running',
    pause: () => (made.playState = 'paused'),
    play: () => (made.playState = 'running'),
  }
  return made
}

test('endless animations around the playground pause until it releases them, its own and short ones go on', () => {
  const [mascot, own, short] = [
    animation('mascot', Infinity),
    animation('own', Infinity),
    animation('mascot', 1),
  ]
  vi.stubGlobal('KeyframeEffect', Effect)
  vi.stubGlobal('document', { getAnimations: () => [mascot, own, short] })
  const states = () => [mascot, own, short].map(({ playState }) => playState)
  const release = holdStill({ contains: (target: string) => target === 'own' } as unknown as Element)
  expect(states()).toEqual(['paused', 'running', 'running'])
  release()
  expect(states()).toEqual(['running', 'running', 'running'])
})

test('of many values the last one is shown with the next frame, a later one after a free frame', () => {
  const draw = screen()
  const shown: number[] = []
  const show = onNextFrame((value) => shown.push(value))
  for (const value of [1, 2, 3]) show(value)
  expect(shown).toEqual([])
  draw()
  expect(shown).toEqual([3])
  show(4)
  draw()
  expect(shown).toEqual([3])
  draw()
  expect(shown).toEqual([3, 4])
  for (let frame = 0; frame < 4; frame += 1) draw()
  show(5)
  draw()
  expect(shown).toEqual([3, 4, 5])
})

test('after a late frame learning gets less of the next one', () => {
  const frame = 1000 / 60
  // All of it has to fit between two frames, with time left to draw.
  expect(budgetFor(frame)).toBe(7)
  expect(budgetFor(2 * frame)).toBe(4)
})
