import { motorAt, withMotor, type MotorPlug, type MotorPort, type RobotConfig } from '@botgarten/simulation'

export type Motor = MotorPlug['kind'] | 'nothing'
export type Wheel = 'left' | 'right' | 'none'

/** Words of a kind of motor. */
export const motorWords: { readonly [kind in Motor]: string } = {
  large: 'robot.plug.motor_big',
  medium: 'robot.plug.motor_middle',
  other: 'robot.plug.actor',
  nothing: 'robot.nothing',
}
export const motorHelp: { readonly [kind in MotorPlug['kind']]: string } = {
  large: 'robot.help.motor_big',
  medium: 'robot.help.motor_middle',
  other: 'robot.help.actor',
}

export const kindAt = (config: RobotConfig, port: MotorPort): Motor =>
  motorAt(config, port)?.kind ?? 'nothing'

/** Which wheel turns with this port, whatever is plugged in. */
export const wheelOf = ({ drive }: RobotConfig, port: MotorPort): Wheel =>
  port === drive.left ? 'left' : port === drive.right ? 'right' : 'none'

/** Another kind of motor at a port. What turns backwards goes on doing so, where such a motor can. */
export function withKind(config: RobotConfig, port: MotorPort, kind: Motor): RobotConfig {
  if (kind === 'nothing') return withMotor(config, port, undefined)
  const before = motorAt(config, port)
  return withMotor(config, port, kind === 'other' ? { kind } : { ...before, kind })
}

/** A motor with one of its two settings on or off. */
export function withSetting(
  config: RobotConfig,
  port: MotorPort,
  setting: 'reversed' | 'unregulated',
  on: boolean,
): RobotConfig {
  const before = motorAt(config, port)
  if (!before) return config
  const { [setting]: _was, ...plug } = before
  return withMotor(config, port, on ? { ...plug, [setting]: true } : plug)
}

/** What is said below a motor's settings: what they change here, and what only on a real robot. */
export function noteOf(config: RobotConfig, port: MotorPort): string {
  if (port !== config.drive.left) return 'robot.onlyRealToo'
  return motorAt(config, port)?.reversed ? 'robot.otherWay' : 'robot.onlyReal'
}

/** How unequal the motors are as one number: below 0 the left one is so many percent weaker, above 0 the right one. */
export function tilt({ strength = { left: 1, right: 1 } }: RobotConfig): number {
  return Math.round((strength.left - strength.right) * 100) + 0
}

export function withTilt({ strength: _before, ...config }: RobotConfig, percent: number): RobotConfig {
  if (percent === 0) return config
  const weaker = 1 - Math.abs(percent) / 100
  return { ...config, strength: percent < 0 ? { left: weaker, right: 1 } : { left: 1, right: weaker } }
}
