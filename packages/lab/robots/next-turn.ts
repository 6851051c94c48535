import type { Host, Robot } from '@botgarten/blocks'
import { runThread } from '@botgarten/programs'
import type { MotorPort, Percent, RobotConfig, SensorPort } from '@botgarten/simulation'
import type { RobotRun } from './run.ts'

/**
 * How the robot's program would turn it in its next tick: right wheel minus left wheel, in percent; null where it would set
 * no wheel. With `mirrored`, had each sensor seen what its mirror image on the other side sees; without `thinks`, had its
 * networks put out 0. Nothing is changed by it.
 * @param now simulated seconds at that tick
 */
export function nextTurn(
  robot: RobotRun,
  { drive, sensors }: RobotConfig,
  now: number,
  mirrored: boolean,
  thinks = true,
): Percent | null {
  const { left, right } = drive
  const own = robot.context.robot
  const wheels: { [port in MotorPort]?: Percent } = {}
  const read: Robot['read'] = (port, mode) => own.read(mirrored ? mirrorOf(port, sensors) : port, mode)
  runThread(structuredClone(robot.thread), robot.index, {
    ...{
      now,
      robot: onlyWheels(own, read, drive, wheels),
      think: (id, inputs) => (thinks ? robot.brains.would(id, inputs) : []),
    },
    ...(robot.context.brain && { brain: robot.context.brain }),
  } satisfies Host)
  if (wheels[left] === undefined && wheels[right] === undefined) return null
  return (wheels[right] ?? own.power(right)) - (wheels[left] ?? own.power(left))
}

/** A robot that acts on nothing: what its motors are told is written down. */
function onlyWheels(
  robot: Robot,
  read: Robot['read'],
  { left, right }: RobotConfig['drive'],
  wheels: { [port in MotorPort]?: Percent },
): Robot {
  const set = (port: MotorPort, percent: Percent) => void (wheels[port] = cut(percent))
  const both = (l: Percent, r: Percent) => (set(left, l), set(right, r))
  const nothing = () => {}
  return {
    ...{ ...robot, read, motor: set, turn: set },
    ...{ move: (order) => both(order.left, order.right), stop: () => both(0, 0) },
    ...{
      led: nothing,
      picture: nothing,
      setVolume: nothing,
      say: nothing,
      language: nothing,
      display: nothing,
    },
    ...{
      clearDisplay: nothing,
      tone: nothing,
      resetEncoder: nothing,
      resetTimer: nothing,
      resetGyro: nothing,
    },
  }
}

const cut = (percent: Percent): Percent => Math.max(-100, Math.min(100, percent))

/** The port of the like sensor on the robot's other side; the same port where there is none. */
function mirrorOf(port: SensorPort, sensors: RobotConfig['sensors']): SensorPort {
  const own = sensors[port]
  const other = (Object.keys(sensors) as SensorPort[]).find((name) => {
    const { kind, x, y, angle } = sensors[name]!
    return own && kind === own.kind && x === own.x && y === 0 - own.y && angle === 0 - own.angle
  })
  return other ?? port
}
