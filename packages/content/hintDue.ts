import type { Block } from '@botgarten/blocks'
import type { CardProgram, HintStep } from './schema/cardTypes.ts'

/** All blocks of a program. The lab loads this file with the first hint, so it shares no code with the materials. */
function blocksOf({ programs }: CardProgram): readonly Block[] {
  const blocks: Block[] = []
  JSON.stringify(programs, (_, value: Block | undefined) => {
    if (value?.type) blocks.push(value)
    return value
  })
  return blocks
}

/** A measure of a program, by its name in a `HintStep`. */
function measured(name: string, program: CardProgram): number {
  const [brain] = Object.values(program.brains)
  if (name === 'knobs')
    return Object.values(brain?.weights ?? {})
      .flatMap((to) => Object.values(to))
      .filter(Boolean).length
  if (name === 'examples') return brain?.examples?.rows.length ?? 0
  if (name === 'rounds') return brain?.practice?.round ?? 0
  const blocks = blocksOf(program)
  if (!name.startsWith('#')) return blocks.filter(({ type }) => type.startsWith(name)).length
  const [number] = Object.values(blocks.find(({ id }) => id === name.slice(1))?.fields ?? {})
  return Number(number ?? 0)
}

const isFollowed = (step: HintStep, program: CardProgram) =>
  Object.entries(step).every(([name, least]) => measured(name, program) >= least)

/**
 * The hint that is due for a program: the first one whose step is missing. A step that no program shows counts as followed
 * once a later one is.
 * @param steps the card's `hintSteps`; undefined: none
 * @returns index of the hint, from 0 to the number of steps
 */
export function hintDue(steps: readonly (HintStep | null)[] | undefined, program: CardProgram): number {
  const followed = (steps ?? []).map((step) => step && isFollowed(step, program))
  const last = followed.lastIndexOf(true)
  const missing = followed.indexOf(false)
  return missing >= 0 && missing < last ? missing : last + 1
}
