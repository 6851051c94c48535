import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { closeSessions, screen, sessionOf } from './testing/session.ts'
import { TimeMachine } from './time.svelte.ts'

beforeEach(() => void vi.spyOn(console, 'warn').mockImplementation(() => {}))
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

/** A lab that runs on a screen. */
function running() {
  const draw = screen()
  const { session } = sessionOf()
  session.learnFirst = () => false
  const stop = session.lab.run()
  session.start()
  return { session, lab: session.lab, draw, stop, time: new TimeMachine(session) }
}

test('time passes as on the clock, or as many times as fast as a child wants', () => {
  // Only frames let time pass: delays of the machine between them do not count.
  vi.spyOn(performance, 'now').mockReturnValue(0)
  const { lab, draw } = running()
  draw(0)
  for (const [speed, seconds] of [
    [1, 0.1],
    [4, 0.4],
    [0.5, 0.05],
  ] as const) {
    const before = lab.view.tick
    lab.speed = speed
    for (let frame = 0; frame < 10; frame += 1) draw(10)
    const passed = (lab.view.tick - before) / TICKS_PER_SECOND
    expect(Math.abs(passed - seconds)).toBeLessThan(1.01 / TICKS_PER_SECOND)
  }
})

test('nothing passes while it is paused, and a stopped lab asks for no frame', () => {
  const { lab, draw, stop } = running()
  draw(100)
  draw(100)
  const { tick } = lab.view
  expect(tick).toBeGreaterThan(0)
  lab.pause()
  for (let frame = 0; frame < 5; frame += 1) draw(100)
  expect(lab.view.tick).toBe(tick)
  lab.resume()
  draw(100)
  draw(100)
  expect(lab.view.tick).toBeGreaterThan(tick)
  stop()
  const last = lab.view.tick
  draw(100)
  expect(lab.view.tick).toBe(last)
})

test('nobody is chosen at first, and a key of the robot is pressed until it is let go', () => {
  const { lab, draw } = running()
  expect(lab.chosen).toBe('')
  const pressed = () => {
    draw(100)
    draw(100)
    return lab.moment.simulation.robots[0]!.keys
  }
  expect(pressed()).toEqual([])
  lab.pressButton('enter', true, 'bo')
  expect(pressed()).toEqual(['enter'])
  lab.pressButton('enter', false, 'bo')
  expect(pressed()).toEqual([])
})

test('the bar of time opens once something has run, and closing it comes back to the present', () => {
  const { session } = sessionOf()
  const still = new TimeMachine(session)
  still.toggle()
  expect([still.empty, still.open, still.past]).toEqual([true, false, false])
  const { lab, draw, time } = running()
  for (let frame = 0; frame < 5; frame += 1) draw(100)
  lab.pause()
  const { tick } = lab.view
  expect([time.empty, time.open]).toEqual([false, false])
  time.toggle()
  expect(time.open).toBe(true)
  time.goTo(5)
  time.step(1)
  time.step(-1)
  time.step(-1)
  expect([time.view.tick, time.past]).toEqual([4, true])
  time.toggle()
  expect([time.view.tick, time.past, time.open]).toEqual([tick, false, false])
  // The next frame shows what was asked for last.
  time.lookAt(2)
  time.lookAt(3)
  expect(time.view.tick).toBe(tick)
  draw(10)
  expect(time.view.tick).toBe(3)
  time.now()
  expect(time.view.tick).toBe(tick)
  time.goTo(5)
  time.goOn()
  expect([time.past, lab.view.phase, lab.facts.other]).toEqual([false, 'running', true])
  time.speed = 8
  expect([lab.speed, time.speed]).toEqual([8, 8])
})

test('an edited program ends the timeline: the bar of time closes until the next run', () => {
  const { session, lab, draw, time } = running()
  for (let frame = 0; frame < 5; frame += 1) draw(100)
  time.toggle()
  expect(time.open).toBe(true)
  const [first, ...others] = session.program.stacks
  const stop = { id: 'stop', type: 'robActions_motorDiff_stop' }
  const stacks = [{ ...first!, blocks: [...first!.blocks, stop] }, ...others]
  session.apply({ kind: 'program', program: 'main', after: { ...session.program, stacks } })
  lab.stop()
  expect([time.empty, time.open]).toEqual([true, false])
  session.start()
  for (let frame = 0; frame < 5; frame += 1) draw(100)
  expect([time.empty, time.open]).toEqual([false, true])
})
