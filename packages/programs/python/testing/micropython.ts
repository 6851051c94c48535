// Runs a generated file in MicroPython against stand-ins of its robot's library, whose motors and sensors are a `Robot` of ours.
import { readdirSync, readFileSync } from 'node:fs'
import { join, relative } from 'node:path'
import type { Robot } from '@botgarten/blocks'
import {
  cardConfig,
  type LedColour,
  type MotorPort,
  type ReadMode,
  type RobotConfig,
  type RobotKey,
  type SensorPort,
} from '@botgarten/simulation'
import { loadMicroPython } from '@micropython/micropython-webassembly-pyscript/micropython.mjs'
import { primePorts } from '../robots/hub.ts'

export { tracingRobot } from './tracing-robot.ts'

const folder = join(import.meta.dirname, 'stand-ins')
const sources = readdirSync(folder, { recursive: true, withFileTypes: true })
  .filter((entry) => entry.name.endsWith('.py'))
  .map(({ parentPath, name }) => {
    const path = join(parentPath, name)
    return [relative(folder, path), readFileSync(path, 'utf8')] as const
  })

/** What a file does with the time. */
export interface Clock {
  /** One tick of 1/60 s goes by. @throws to end the run */
  readonly tick: () => void
  /** Uniform in [0, 1). */
  readonly random: () => number
}

export interface Ran {
  /** What ended it; null: its last line. */
  readonly error: string | null
  readonly printed: readonly string[]
}

/** Ticks that last no shorter than so many ms (semantics.md, rule 5). */
const ticksIn = (ms: number) => Math.max(0, Math.ceil((ms * 60) / 1000 - 1e-9))

/** Python's None comes as null or undefined. */
const none = <Value>(value: Value | null | undefined): Value | null => value ?? null

/** Which sensor of the configuration a SPIKE Prime hub has at a port, or `gyro` built in. */
function plugAt(config: RobotConfig, place: string): string | null {
  const { sensors } = config
  if (place === 'gyro')
    return Object.keys(sensors).find((port) => sensors[port as keyof typeof sensors]?.kind === place) ?? null
  return Object.entries(primePorts(config)).find(([, plug]) => plug === place)?.[0] ?? null
}

const brickOf = (robot: Robot, { tick, random }: Clock, config: RobotConfig) => ({
  wait(ms: number) {
    for (let k = ticksIn(ms); k > 0; k--) tick()
  },
  random,
  plug: (place: string) => plugAt(config, place),
  read: (port: SensorPort, mode: ReadMode) => robot.read(port, mode),
  motor: (port: MotorPort, percent: number) => robot.motor(port, percent),
  move: (left: number, right: number, degrees: number) => robot.move({ left, right, degrees }),
  arrived: () => robot.arrived(),
  turn: (port: MotorPort, percent: number, degrees: number) => robot.turn(port, percent, degrees),
  turned: (port: MotorPort) => robot.turned(port),
  power: (port: MotorPort) => robot.power(port),
  encoder: (port: MotorPort) => robot.encoder(port),
  reset_encoder: (port: MotorPort) => robot.resetEncoder(port),
  reset_gyro: (port: SensorPort) => robot.resetGyro(port),
  timer: (number: number) => robot.timer(number),
  reset_timer: (number: number) => robot.resetTimer(number),
  key: (key: RobotKey | 'any') => robot.key(key),
  led: (colour: LedColour | null, blink: 'flash' | 'double' | null) =>
    none(blink) === null ? robot.led(none(colour)) : robot.led(none(colour), blink ?? undefined),
  display: (row: number, column: number, text: string) => robot.display(row, column, text),
  clear: () => robot.clearDisplay(),
  tone: (hertz: number, seconds: number | null) => robot.tone(hertz, none(seconds)),
  volume: () => robot.volume(),
  set_volume: (percent: number) => robot.setVolume(percent),
  say: (text: string) => robot.say(text, 30, 50),
})

/** Pybricks calls its modules so; MicroPython would take its own `random` for `urandom`. */
const bootstrap = `import sys
sys.path.insert(0, "/stand-ins")
import math, random
sys.modules["umath"] = math
sys.modules["urandom"] = random`

/** Runs a file to its end, or until the clock throws. @param config what is plugged in where */
export async function runPython(
  text: string,
  robot: Robot,
  clock: Clock,
  config: RobotConfig = cardConfig,
): Promise<Ran> {
  const printed: string[] = []
  const python = await loadMicroPython({ heapsize: 4_000_000, stdout: (line) => void printed.push(line) })
  makeFolder(python.FS, '/stand-ins')
  for (const [path, source] of sources) {
    const parts = path.split('/').slice(0, -1)
    parts.forEach((_, k) => makeFolder(python.FS, `/stand-ins/${parts.slice(0, k + 1).join('/')}`))
    python.FS.writeFile(`/stand-ins/${path}`, source)
  }
  python.registerJsModule('brick', brickOf(robot, clock, config))
  python.runPython(bootstrap)
  try {
    python.runPython(text)
    return { error: null, printed }
  } catch (error) {
    return { error: String((error as Error).message), printed }
  }
}

function makeFolder(files: { mkdir(path: string): void }, path: string): void {
  try {
    files.mkdir(path)
  } catch {
    // It is there already.
  }
}
