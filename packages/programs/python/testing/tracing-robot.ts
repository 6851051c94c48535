import type { Robot } from '@botgarten/blocks'
import { draw, stream } from '@botgarten/numbers'
import type { ReadMode } from '@botgarten/simulation'

/** What a robot was told, in order. */
export type Command = readonly [verb: string, ...facts: readonly unknown[]]

export interface Tracing {
  readonly robot: Robot
  readonly log: Command[]
}

/** So many commands are compared of one run. */
const most = 300
export const enough = 'enough is compared'

/** From a count to a reading. */
const readings: { readonly [mode in ReadMode]?: (k: number) => number | string } = {
  distance: (k) => (k * 7) % 256,
  light: (k) => (k * 3) % 101,
  colour: (k) => (k % 3 === 0 ? '#B30006' : '#FFFFFF'),
  red: (k) => k % 256,
  green: (k) => (k * 2) % 256,
  blue: () => 255,
}

/**
 * A robot that writes down what it is told. What it reads depends on what it was told and on how often it was asked
 * since, never on ticks: a loop of Python waits where the blocks' one may go on (python.md, "Time").
 */
export function tracingRobot(): Tracing {
  const log: Command[] = []
  const asked = new Map<string, number>()
  const write = (verb: string, ...facts: unknown[]) => {
    asked.clear()
    if (log.length >= most) throw new Error(enough)
    log.push([verb, ...facts])
  }
  const count = (what: string) => {
    const times = (asked.get(what) ?? 0) + 1
    asked.set(what, times)
    return log.length * 5 + times
  }
  const both = (left: number, right: number) => {
    write('motor', 'C', left)
    write('motor', 'B', right)
  }
  const robot: Robot = {
    read(port, mode) {
      const wanted = port === '1' ? mode !== 'distance' : mode === 'distance'
      const reading = port === '4' || !wanted ? undefined : readings[mode]
      // Python reads all parts of a colour at once.
      const k = /^(red|green|blue)$/.test(mode) ? log.length * 5 : count(port + mode)
      return reading?.(k) ?? null
    },
    motor: (port, percent) => write('motor', port, percent),
    move: ({ left, right, degrees }) =>
      degrees === undefined ? both(left, right) : write('move', left, right, degrees),
    arrived: () => true,
    stop: () => both(0, 0),
    power: (port) => (port === 'B' ? 30 : -20),
    turn: (port, percent, degrees) => write('turn', port, percent, degrees),
    turned: () => true,
    led: (colour, blink) => write('led', colour, blink),
    picture: () => {},
    volume: () => 50,
    setVolume: (percent) => write('volume', percent),
    say: (text) => write('say', text),
    language: () => {},
    display: (row, column, text) => write('display', row, column, text),
    clearDisplay: () => write('clear'),
    tone: (frequency, seconds) => frequency > 0 && write('tone', frequency, seconds),
    encoder: (port) => (port === 'B' ? 90 : 720) + count(`encoder${port}`),
    resetEncoder: (port) => write('resetEncoder', port),
    timer: () => 1000 + count('timer'),
    resetTimer: () => write('resetTimer'),
    resetGyro: (port) => write('resetGyro', port),
    key: (key) => count(`key${key}`) % 4 === 0,
    wheelDiameter: 5.6,
    trackWidth: 18,
  }
  return { robot, log }
}

/** The stream of a thread that was started without a seed. */
export function chance(): () => number {
  const state = stream(0, 'program')
  return () => draw(state)
}
