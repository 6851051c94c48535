import type { MotorPlug, MotorPort, RobotConfig } from '../types.ts'

export const motorPorts = ['A', 'B', 'C', 'D'] as const satisfies readonly MotorPort[]

type Driven = Pick<RobotConfig, 'motors' | 'drive'>

/** Where a robot does not say what is plugged in, large motors drive its wheels. */
export const motorAt = ({ motors, drive }: Driven, port: MotorPort): MotorPlug | undefined =>
  motors ? motors[port] : port === drive.left || port === drive.right ? { kind: 'large' } : undefined

export const isSameMotor = (a: MotorPlug | undefined, b: MotorPlug | undefined): boolean =>
  a?.kind === b?.kind && a?.reversed === b?.reversed && a?.unregulated === b?.unregulated

export const isSameMotors = (a: Driven, b: Driven): boolean =>
  motorPorts.every((port) => isSameMotor(motorAt(a, port), motorAt(b, port)))

/** The configuration with these motors; it says nothing of them where they are the usual ones. */
export function withMotors(config: RobotConfig, motors: NonNullable<RobotConfig['motors']>): RobotConfig {
  const { motors: _before, ...bare } = config
  return isSameMotors({ ...bare, motors }, bare) ? bare : { ...bare, motors }
}

/** The configuration with another motor at a port, or none. */
export function withMotor(config: RobotConfig, port: MotorPort, plug: MotorPlug | undefined): RobotConfig {
  const others = motorPorts.filter((other) => other !== port)
  const plugged = [...others.map((other) => [other, motorAt(config, other)] as const), [port, plug] as const]
  return withMotors(config, Object.fromEntries(plugged.filter(([, motor]) => motor !== undefined)))
}

/** A motor drives the wheel of a side from now on; the motors change wheels where it drove the other one. */
export function withWheel(config: RobotConfig, port: MotorPort, side: 'left' | 'right'): RobotConfig {
  const { drive } = config
  const other = side === 'left' ? 'right' : 'left'
  const kept = drive[other] === port ? drive[side] : drive[other]
  const motors = Object.fromEntries(
    motorPorts.flatMap((one) => {
      const plug = motorAt(config, one)
      return plug ? [[one, plug]] : []
    }),
  )
  return withMotors({ ...config, drive: { ...drive, [side]: port, [other]: kept } }, motors)
}
