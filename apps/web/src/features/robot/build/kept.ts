import { robotConfigSchema } from '@botgarten/programs'
import type { RobotConfig } from '@botgarten/simulation'
import * as v from 'valibot'
import { readSetting, writeSetting } from '#storage/settings.ts'

/** Robots that were built on this device, by the name they were given. */
export type KeptRobots = { readonly [name: string]: RobotConfig }

export const mostKept = 30
export const longestName = 40

/** What lies on a device, or comes with a home file; a robot that is none is left out. */
export function robotsFrom(data: unknown): KeptRobots {
  const found = v.safeParse(v.record(v.string(), v.unknown()), data)
  if (!found.success) return {}
  const robots = Object.entries(found.output).flatMap(([name, config]) => {
    const { success, output } = v.safeParse(robotConfigSchema, config)
    return success && name !== '' && name.length <= longestName ? [[name, output] as const] : []
  })
  return Object.fromEntries(robots.slice(0, mostKept))
}

export const readRobots = (): KeptRobots => robotsFrom(readSetting<unknown>('robots', {}))

/** Keeps these robots. What lies on the device then, which is less where it refuses. */
export function keepRobots(robots: KeptRobots): KeptRobots {
  writeSetting('robots', robots)
  return readRobots()
}

/** With one more, or another one under its name, in the order of the alphabet; null where there are too many. */
export function withKept(robots: KeptRobots, name: string, config: RobotConfig): KeptRobots | null {
  const next = Object.entries({ ...robots, [name]: config }).sort(([a], [b]) => a.localeCompare(b))
  return next.length > mostKept ? null : Object.fromEntries(next)
}

export function withoutKept(robots: KeptRobots, name: string): KeptRobots {
  const { [name]: _, ...others } = robots
  return others
}
