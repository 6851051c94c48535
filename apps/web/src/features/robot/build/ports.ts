import { partOf } from '@botgarten/blocks/configuration'
import type { Program } from '@botgarten/programs'
import { withoutSensor, withSensor, type RobotConfig, type SensorPort } from '@botgarten/simulation'

export const ports = ['1', '2', '3', '4'] as const satisfies readonly SensorPort[]

export const freePort = ({ sensors }: RobotConfig): SensorPort | null =>
  ports.find((port) => sensors[port] === undefined) ?? null

/** Plugs a sensor over to another port; what sat there comes back in exchange. */
export function movedOver(config: RobotConfig, from: SensorPort, to: SensorPort): RobotConfig {
  const moving = config.sensors[from]
  const other = config.sensors[to]
  if (!moving || from === to) return config
  const plugged = withSensor(config, to, moving)
  return other ? withSensor(plugged, from, other) : withoutSensor(plugged, from)
}

/** Ports at which a file's configuration has something plugged in that nobody here knows; it stays in the file. */
export function unknownPorts(config: Program['config']): readonly string[] {
  const brick = config.stacks
    .flatMap(({ blocks }) => blocks)
    .find(({ type }) => type === 'robBrick_EV3-Brick')
  return Object.entries(brick?.values ?? {})
    .filter(([, { type }]) => partOf(type) === undefined)
    .map(([port]) => port.slice(1))
}
