import type { RobotConfig } from '@botgarten/simulation'

/** How unequal the motors are as one number: below 0 the left one is so many percent weaker, above 0 the right one. */
export function tilt({ strength = { left: 1, right: 1 } }: RobotConfig): number {
  return Math.round((strength.left - strength.right) * 100) + 0
}

export function withTilt({ strength: _before, ...config }: RobotConfig, percent: number): RobotConfig {
  if (percent === 0) return config
  const weaker = 1 - Math.abs(percent) / 100
  return { ...config, strength: percent < 0 ? { left: weaker, right: 1 } : { left: 1, right: weaker } }
}
