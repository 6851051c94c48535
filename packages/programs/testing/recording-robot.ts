import type { CheckContext, Host, Mail, Robot } from '@botgarten/blocks'
import type { ReadMode, SensorKind } from '@botgarten/simulation'

/** What a robot was told, in order, with the tick. */
export type Entry = readonly [tick: number, verb: string, ...facts: readonly unknown[]]

export interface Recording {
  readonly context: Host & { now: number }
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
  touch: (tick: number) => tick % 2,
  angle: (tick: number) => tick * 3 - 90,
  rate: (tick: number) => 180 - tick,
  infrared: (tick: number) => (tick * 9) % 101,
  sound: (tick: number) => (tick * 11) % 101,
  compass: (tick: number) => (tick * 90) % 360,
  x: (tick: number) => tick / 2,
  y: (tick: number) => 100 - tick,
  heading: (tick: number) => (tick * 5) % 360,
}

/** The cards' robot. */
export const cardSensors = {
  1: { kind: 'colour' },
  2: { kind: 'ultrasonic' },
  3: { kind: 'ultrasonic' },
} as const satisfies CheckContext['sensors']

const kinds: { readonly [mode in ReadMode]?: SensorKind } = {
  touch: 'touch',
  angle: 'gyro',
  rate: 'gyro',
  infrared: 'infrared',
  sound: 'sound',
  compass: 'compass',
  x: 'position',
  y: 'position',
  heading: 'position',
}

/** A net from n1 to n2, for the blocks around `robActions_NNstep`. */
const smallNet = {
  layers: [[{ id: 'n1', bias: 0 }], [{ id: 'n2', bias: 1 }]],
  weights: { n1: { n2: 2 } },
}

/** One other robot. */
const mailTo = (write: (verb: string, ...facts: unknown[]) => void): Mail => ({
  find: (name) => (name === 'Bo 2' ? 'bo2' : null),
  send: (to, { kind, text }) => write('send', to, kind, text),
})

/** Each move with degrees takes three ticks. */
const moveTicks = 3

/**
 * A robot that writes down what it is told. Colour at port 1, distance at 2 and 3, or other sensors; a brain whose every
 * output is the sum of its inputs, `outputs` of them.
 */
export function recordingRobot(outputs = 2, sensors: CheckContext['sensors'] = cardSensors): Recording {
  const log: Entry[] = []
  let movedAt = -Infinity
  let turnedAt = -Infinity
  const write = (verb: string, ...facts: unknown[]) => void log.push([recording.tick, verb, ...facts])
  const robot: Robot = {
    read(port, mode) {
      const wanted = mode === 'distance' ? 'ultrasonic' : (kinds[mode] ?? 'colour')
      return sensors[port]?.kind === wanted ? readings[mode](recording.tick) : null
    },
    motor: (port, percent) => write('motor', port, percent),
    move(order) {
      movedAt = recording.tick
      write('move', order.left, order.right, order.degrees)
    },
    arrived: () => recording.tick >= movedAt + moveTicks,
    stop: () => write('stop'),
    power: (port) => (port === 'B' ? 30 : -20),
    turn: (port, percent, degrees) => {
      turnedAt = recording.tick
      write('turn', port, percent, degrees)
    },
    turned: () => recording.tick >= turnedAt + moveTicks,
    led: (colour, ...blink) => write('led', colour, ...blink),
    picture: (name) => write('picture', name),
    volume: () => 50,
    setVolume: (percent) => write('volume', percent),
    say: (text, speed, pitch) => write('say', text, speed, pitch),
    language: (name) => write('language', name),
    display: (row, column, text) => write('display', row, column, text),
    clearDisplay: () => write('clearDisplay'),
    tone: (frequency, seconds) => write('tone', frequency, seconds),
    encoder: (port) => (port === 'B' ? 90 : 720) + recording.tick,
    resetEncoder: (port) => write('resetEncoder', port),
    timer: (number) => (number >= 1 && number <= 5 ? number * 1000 + recording.tick : null),
    resetTimer: (number) => write('resetTimer', number),
    resetGyro: (port) => write('resetGyro', port),
    key: (key) => key === 'any' || key === 'left',
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
    context: { robot, think, now: 0, brain: () => smallNet, mail: mailTo(write), trying: tryingOf(write) },
  }
  return recording
}

/** Has tried for long enough at once, and holds what it does for a quarter of a second. */
const tryingOf = (write: (verb: string) => void): NonNullable<Host['trying']> => ({
  learn: () => {
    write('learn')
    return true
  },
  act: () => {
    write('act')
    return 15
  },
})

/** One tick further. */
export function nextTick(recording: Recording): void {
  recording.tick++
  recording.context.now = recording.tick / 60
}
