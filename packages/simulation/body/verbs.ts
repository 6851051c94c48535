import type {
  Degrees,
  Hertz,
  LedColour,
  MotorPort,
  Percent,
  RobotState,
  Seconds,
  Simulation,
} from '../types.ts'
import { PORTS } from '../sensors/noise.ts'
import { TICKS_PER_SECOND } from '../time.ts'

/** 178 × 128 px hold this many rows and columns of whole letters, 10 × 16 px each; what is written beyond is not shown. */
const DISPLAY_ROWS = 8
const DISPLAY_COLUMNS = 17

const robotOf = (sim: Simulation, robot: number) => sim.state.robots[robot]!
const driveOf = (sim: Simulation, robot: number) => sim.world.robots[robot]!.config.drive
const held = (percent: Percent): Percent => Math.max(-100, Math.min(100, percent || 0))

/**
 * Sets a motor's speed, cut to −100..100 percent, until it is set again. A wheel that is set takes part in no move any
 * more: the move ends, and the other wheel, which ran for it alone, stops.
 */
export function setMotor(sim: Simulation, robot: number, port: MotorPort, percent: Percent): void {
  const state = robotOf(sim, robot)
  const { left, right } = driveOf(sim, robot)
  if (state.move && (port === left || port === right)) stopMotors(sim, robot)
  state.motors[port].percent = held(percent)
  state.motors[port].left = null
}

/** Turns one motor so far (degrees ≥ 0) at this speed; it stops by itself. Speed or way 0: it stands at once. */
export function turnMotor(
  sim: Simulation,
  robot: number,
  port: MotorPort,
  percent: Percent,
  degrees: Degrees,
): void {
  const way = degrees > 0 && percent !== 0 ? degrees : 0
  setMotor(sim, robot, port, way > 0 ? percent : 0)
  robotOf(sim, robot).motors[port].left = way > 0 ? way : null
}

/** Has a motor's last turn ended? */
export const motorTurned = (sim: Simulation, robot: number, port: MotorPort): boolean =>
  robotOf(sim, robot).motors[port].left === null

/**
 * Sets both wheels. With `degrees` the faster wheel turns that far (backwards when negative), the other in proportion,
 * and the move ends by itself; without, they turn until set again. With a reversed left motor both turn the other way.
 */
export function startMove(
  sim: Simulation,
  robot: number,
  order: { readonly left: Percent; readonly right: Percent; readonly degrees?: Degrees },
): void {
  const state = robotOf(sim, robot)
  const drive = driveOf(sim, robot)
  const sign = (order.degrees ?? 0) < 0 !== isBackToFront(sim, robot) ? -1 : 1
  const left = held(order.left * sign)
  const right = held(order.right * sign)
  state.motors[drive.left].percent = left
  state.motors[drive.right].percent = right
  state.motors[drive.left].left = state.motors[drive.right].left = null
  state.move = null
  if (order.degrees !== undefined) limit(sim, robot, Math.abs(order.degrees) || 0)
}

/** Open Roberta asks the left wheel's motor alone. */
function isBackToFront(sim: Simulation, robot: number): boolean {
  const { motors, drive } = sim.world.robots[robot]!.config
  return motors?.[drive.left]?.reversed === true
}

function limit(sim: Simulation, robot: number, degrees: Degrees): void {
  const state = robotOf(sim, robot)
  const drive = driveOf(sim, robot)
  const left = Math.abs(state.motors[drive.left].percent)
  const right = Math.abs(state.motors[drive.right].percent)
  const faster = Math.max(left, right)
  if (faster === 0 || degrees === 0) return stopMotors(sim, robot)
  state.move = { left: (degrees * left) / faster, right: (degrees * right) / faster }
}

/** Has the last move with `degrees` ended? */
export function arrived(sim: Simulation, robot: number): boolean {
  return robotOf(sim, robot).move === null
}

/** Stops both wheels at once; a move ends. Other motors go on. */
export function stopMotors(sim: Simulation, robot: number): void {
  const state = robotOf(sim, robot)
  const { left, right } = driveOf(sim, robot)
  state.motors[left].percent = 0
  state.motors[right].percent = 0
  state.motors[left].left = state.motors[right].left = null
  state.move = null
}

/** `blink`: how the lamp lights; not given: it stays on. */
export function setLed(
  sim: Simulation,
  robot: number,
  colour: LedColour | null,
  blink: RobotState['blink'] = null,
): void {
  const state = robotOf(sim, robot)
  state.led = colour
  state.blink = colour === null ? null : blink
}

/** A picture in place of all that is on the display. */
export function showPicture(sim: Simulation, robot: number, name: string): void {
  clearDisplay(sim, robot)
  robotOf(sim, robot).picture = name
}

export function setVolume(sim: Simulation, robot: number, percent: Percent): void {
  robotOf(sim, robot).volume = Math.max(0, Math.min(100, percent || 0))
}

export function setLanguage(sim: Simulation, robot: number, name: string): void {
  robotOf(sim, robot).language = name
}

/** Says a text in the robot's language. */
export function say(sim: Simulation, robot: number, text: string, speed: Percent, pitch: Percent): void {
  const state = robotOf(sim, robot)
  state.speech = { text, language: state.language, speed, pitch, tick: sim.state.tick }
}

/** Replaces what stands in `row` (0 at the top) from `column` (0 at the left) on. Outside the display nothing happens. */
export function display(sim: Simulation, robot: number, row: number, column: number, text: string): void {
  const state = robotOf(sim, robot)
  const rows = state.display
  const line = Math.floor(row)
  const from = Math.floor(column)
  if (!(line >= 0 && line < DISPLAY_ROWS && from >= 0 && from < DISPLAY_COLUMNS)) return
  state.picture = null
  while (rows.length <= line) rows.push('')
  // A letter may be two units long. What comes behind the edge is not looked at.
  const before = [...rows[line]!].slice(0, from).join('')
  const room = DISPLAY_COLUMNS - from
  rows[line] =
    before + ' '.repeat(from - [...before].length) + [...text.slice(0, 2 * room)].slice(0, room).join('')
}

export function clearDisplay(sim: Simulation, robot: number): void {
  robotOf(sim, robot).display = []
  robotOf(sim, robot).picture = null
}

/** Sounds a tone for `seconds`; null: until it is changed. A frequency that is not above 0 is silence. */
export function tone(sim: Simulation, robot: number, frequency: Hertz, seconds: Seconds | null): void {
  const ticks = seconds === null ? null : Math.round(seconds * TICKS_PER_SECOND)
  const silent = !(frequency > 0) || (ticks !== null && !(ticks > 0))
  robotOf(sim, robot).tone = silent
    ? null
    : { frequency, untilTick: ticks === null ? null : sim.state.tick + ticks }
}

/** Everything but the place as at the start of a run: motors, encoders, gyros, timers, lamp, display, sound. */
export function freshRobot(robot: RobotState): void {
  for (const motor of Object.values(robot.motors)) {
    motor.percent = 0
    motor.turned = 0
    motor.left = null
  }
  robot.move = null
  robot.led = null
  robot.blink = null
  robot.picture = null
  robot.volume = 50
  robot.language = ''
  robot.speech = null
  robot.display = []
  robot.tone = null
  robot.spin = 0
  robot.late = null
  robot.timers.fill(0)
  for (const port of PORTS) robot.gyroZero[port] = robot.heading
}
