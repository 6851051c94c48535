import type { Context, Robot } from '@botgarten/blocks'

/** What a robot was told, in order, with the tick. */
export type Entry = readonly [tick: number, verb: string, ...facts: readonly unknown[]]

export interface Recording {
  readonly context: Context & { now: number }
  readonly log: Entry[]
  tick: number
}

/** Readings of the tick, equal for everybody who asks in it. */
const readings = {
  distance: (tick: number) => (tick * 7) % 256,
  light: (tick: number) => (tick * 3) % 101,
  colour: (tick: number) => (tick % 3 === 0 ? '#B30006' : '#FFFFFF'),
  red: (tick: number) => tick % 256,
  green: (tick: number) => (tick * 2) % 256,
  blue: () => 255,
}

/** Each move with degrees takes three ticks. */
const moveTicks = 3

/**
 * A robot that writes down what it is told. Colour at port 1, distance at 2 and 3; a brain whose every output is the
 * sum of its inputs, `outputs` of them.
 */
export function recordingRobot(outputs = 2): Recording {
  const log: Entry[] = []
  let movedAt = -Infinity
  const write = (verb: string, ...facts: unknown[]) => void log.push([recording.tick, verb, ...facts])
  const robot: Robot = {
    read(port, mode) {
      const kind = port === '1' ? 'colour' : port === '4' ? 'none' : 'ultrasonic'
      const fits = mode === 'distance' ? kind === 'ultrasonic' : kind === 'colour'
      return fits ? readings[mode](recording.tick) : null
    },
    motor: (port, percent) => write('motor', port, percent),
    move(order) {
      movedAt = recording.tick
      write('move', order.left, order.right, order.degrees)
    },
    arrived: () => recording.tick >= movedAt + moveTicks,
    stop: () => write('stop'),
    led: (colour) => write('led', colour),
    display: (row, column, text) => write('display', row, column, text),
    clearDisplay: () => write('clearDisplay'),
    tone: (frequency, seconds) => write('tone', frequency, seconds),
    wheelDiameter: 5.6,
    trackWidth: 18,
  }
  const think = (id: string, inputs: readonly number[]) => {
    write('think', id, [...inputs])
    const sum = inputs.reduce((a, b) => a + b, 0)
    return Array.from({ length: outputs }, (_, k) => sum / (k + 1))
  }
  const recording: Recording = {
    log,
    tick: 0,
    context: { robot, think, now: 0 },
  }
  return recording
}

/** One tick further. */
export function nextTick(recording: Recording): void {
  recording.tick++
  recording.context.now = recording.tick / 60
}
