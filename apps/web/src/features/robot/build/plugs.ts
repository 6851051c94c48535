import { partOf } from '@botgarten/blocks/configuration'
import type { Program } from '@botgarten/programs'

/** Ports at which a file's configuration has something plugged in that nobody here knows; it stays in the file. */
export function unknownPorts(config: Program['config']): readonly string[] {
  const brick = config.stacks
    .flatMap(({ blocks }) => blocks)
    .find(({ type }) => type === 'robBrick_EV3-Brick')
  return Object.entries(brick?.values ?? {})
    .filter(([, { type }]) => partOf(type) === undefined)
    .map(([port]) => port.slice(1))
}
