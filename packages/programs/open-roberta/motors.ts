import type { Block } from '@botgarten/blocks'
import { partOf, parts } from '@botgarten/blocks/configuration'
import {
  defaultConfig,
  isSameMotor,
  isSameMotors,
  motorAt,
  motorPorts,
  type MotorPlug,
  type MotorPort,
  type RobotConfig,
} from '@botgarten/simulation'

type Motors = NonNullable<RobotConfig['motors']>
type Side = 'LEFT' | 'RIGHT' | 'NONE'

/** The first motor of each side drives its wheel (Open Roberta); where none does, one of the robot out of the box. */
export function sidesIn({ values }: Block): RobotConfig['drive'] {
  const first = (side: Side) =>
    motorPorts.find((port) => values?.[`M${port}`]?.fields?.['MOTOR_DRIVE'] === side)
  const usual = defaultConfig.drive
  const left = first('LEFT') ?? (first('RIGHT') === usual.left ? usual.right : usual.left)
  return { left, right: first('RIGHT') ?? (left === usual.right ? usual.left : usual.right) }
}

/** What a brick has at its motor ports; nothing where it says no more than that large motors drive the wheels. */
export function motorsIn(brick: Block): Pick<RobotConfig, 'motors'> {
  const motors = pluggedInto(brick)
  const drive = sidesIn(brick)
  const isUsual = Object.keys(motors).length === 0 || isSameMotors({ motors, drive }, { drive })
  return isUsual ? {} : { motors }
}

const pluggedInto = ({ values }: Block): Motors =>
  Object.fromEntries(
    motorPorts.flatMap((port) => {
      const plug = motorOf(values?.[`M${port}`])
      return plug ? [[port, plug]] : []
    }),
  )

/** Which motor a block is; undefined where it is none, is switched off, or nobody knows it. */
function motorOf(block: Block | undefined): MotorPlug | undefined {
  const is = block && block.disabled !== true ? partOf(block.type)?.is : undefined
  if (!is || !('motor' in is)) return undefined
  const { fields } = block!
  return {
    kind: is.motor,
    ...(fields?.['MOTOR_REVERSE'] === 'ON' && { reversed: true }),
    ...(fields?.['MOTOR_REGULATION'] === 'FALSE' && { unregulated: true }),
  }
}

type Driven = Pick<RobotConfig, 'motors' | 'drive'>

/** The block for a port: the old one where it says the same, with all that nobody here knows. */
export function motorFor(port: MotorPort, robot: Driven, old: Block | undefined): Block | undefined {
  const plug = motorAt(robot, port)
  const was = motorOf(old)
  if (!plug && !was) return old
  const side = sideOf(robot.drive, port, plug)
  if (isSameMotor(was, plug) && side === (old?.fields?.['MOTOR_DRIVE'] ?? 'NONE')) return old
  const part = parts.find(({ is }) => 'motor' in is && is.motor === plug?.kind)
  if (!plug || !part) return undefined
  const said: { readonly [name: string]: string } = {
    MOTOR_REGULATION: plug.unregulated ? 'FALSE' : 'TRUE',
    MOTOR_REVERSE: plug.reversed ? 'ON' : 'OFF',
    MOTOR_DRIVE: side,
  }
  const fields = Object.fromEntries(part.fields.map(({ name }) => [name, said[name]!]))
  const block = old?.type === part.type ? old : { id: `motor${port}`, type: part.type }
  return { ...block, ...(part.fields.length > 0 && { fields: { ...block.fields, ...fields } }) }
}

/** Only a large motor drives a wheel. */
const sideOf = ({ left, right }: RobotConfig['drive'], port: MotorPort, plug: MotorPlug | undefined): Side =>
  plug?.kind !== 'large' ? 'NONE' : port === left ? 'LEFT' : port === right ? 'RIGHT' : 'NONE'
