import type { Block } from '@botgarten/blocks'
import type { Program } from '../types.ts'

/** Blocks that only this lab, or the lab of the thesis, has: today's Open Roberta shows nothing in their place. */
const isOurs = (type: string) => /^(ai|rl)_/.test(type) || type === 'robSensors_odometry_getSample'

/** What a strange block belongs to, for one sentence about it. */
export type Kin = 'network' | 'learning' | 'sorting' | 'position'

/** What of a program today's Open Roberta does not know, each once. Other blocks that are unknown here may be its own. */
export function strangersIn({ stacks }: Program): readonly Kin[] {
  const types = new Set(stacks.flatMap(({ blocks }) => blocks.flatMap(typesIn)))
  return [...new Set([...types].filter(isOurs).map(kinOf))].sort()
}

function kinOf(type: string): Kin {
  if (/^(ai_q|rl)_/.test(type)) return 'learning'
  if (type.startsWith('ai_sorting')) return 'sorting'
  return type.startsWith('ai_') ? 'network' : 'position'
}

const typesIn = ({ type, values, statements }: Block): readonly string[] => [
  type,
  ...[...Object.values(values ?? {}), ...Object.values(statements ?? {}).flat()].flatMap(typesIn),
]
