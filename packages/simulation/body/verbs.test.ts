import { expect, test } from 'vitest'
import { clearDisplay, display, freshRobot, setLed, startMove, tone } from '../index.ts'
import { run, start } from '../testing/worlds.ts'

test('a display row keeps what stands before the column and loses what stood from it on', () => {
  const sim = start()
  display(sim, 0, 1, 0, 'hello there')
  display(sim, 0, 1, 6, 'you')
  expect(sim.state.robots[0]!.display).toEqual(['', 'hello you'])
  display(sim, 0, 0, 3, 'x')
  expect(sim.state.robots[0]!.display).toEqual(['   x', 'hello you'])
  clearDisplay(sim, 0)
  expect(sim.state.robots[0]!.display).toEqual([])
})

test.each([
  [-1, 0],
  [1e9, 0],
  [0, -1],
  [0, 1e9],
  [NaN, 0],
  [0, Infinity],
])('outside the display, at row %d and column %d, nothing is written', (row, column) => {
  const sim = start()
  display(sim, 0, row, column, 'x')
  expect(sim.state.robots[0]!.display).toEqual([])
})

test('a long text is cut at the edge of the display', () => {
  const sim = start()
  display(sim, 0, 0, 13, 'abcdefgh'.repeat(10_000))
  expect(sim.state.robots[0]!.display[0]).toBe(`${' '.repeat(13)}abcd`)
})

// leJOS, which Open Roberta's EV3 runs, has 178 / 10 = 17 columns and 128 / 16 = 8 rows of its default font.
test('of 17 letters all are shown, of 18 the first 17, and of nine rows eight', () => {
  const sim = start()
  const letters = 'abcdefghijklmnopqr'
  display(sim, 0, 0, 0, letters.slice(0, 17))
  display(sim, 0, 1, 0, letters)
  display(sim, 0, 2, 0, '😀'.repeat(18))
  display(sim, 0, 2, 16, 'x')
  for (const row of [3, 4, 5, 6, 7, 8]) display(sim, 0, row, 16, `${row}!`)
  display(sim, 0, 0, 17, 'x')
  const { display: rows } = sim.state.robots[0]!
  expect(rows.slice(0, 3)).toEqual([letters.slice(0, 17), letters.slice(0, 17), `${'😀'.repeat(16)}x`])
  expect(rows).toHaveLength(8)
  expect(rows[7]).toBe(`${' '.repeat(16)}7`)
})

test('a tone sounds until it is changed; 0 Hz and no time are silence', () => {
  const sim = start()
  tone(sim, 0, 440, null)
  run(sim, 500)
  expect(sim.state.robots[0]!.tone).toEqual({ frequency: 440, untilTick: null })
  for (const [hertz, seconds] of [
    [0, null],
    [NaN, null],
    [440, 0],
    [440, -1],
    [440, NaN],
  ] as const) {
    // prettier-ignore
    tone(sim, 0, 440, null)
    tone(sim, 0, hertz, seconds)
    expect(sim.state.robots[0]!.tone).toBeNull()
  }
})

test('a fresh robot has forgotten everything but its place', () => {
  const sim = start()
  const untouched = start()
  setLed(sim, 0, 'green')
  display(sim, 0, 0, 0, 'hi')
  tone(sim, 0, 440, null)
  startMove(sim, 0, { left: 40, right: 60, degrees: 900 })
  run(sim, 20)
  const { x, y, heading } = sim.state.robots[0]!
  freshRobot(sim.state.robots[0]!)
  const gyroZero = { '1': heading, '2': heading, '3': heading, '4': heading }
  expect(sim.state.robots[0]).toEqual({ ...untouched.state.robots[0], x, y, heading, gyroZero })
})
