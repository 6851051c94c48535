import type { Block } from '@botgarten/blocks'
import type { CardProgram, HintStep } from './schema/cardTypes.ts'

/** Types of blocks that begin a stack that runs: the start, an activity, a function. */
const hats = /^rob(Controls_(start|activity)|Procedures_)/

/** The blocks that run: those below a hat. The lab loads this file with the first hint, so it shares no code with the materials. */
function blocksOf({ programs }: CardProgram): readonly Block[] {
  const stacks = Object.values(programs).flatMap((program) => program.stacks)
  const blocks: Block[] = []
  JSON.stringify(
    stacks.filter((stack) => hats.test(stack.blocks[0]?.type ?? '')),
    (_, value: Block | undefined) => {
      if (value?.type) blocks.push(value)
      return value
    },
  )
  return blocks
}

/** A measure of a program, by its name in a `HintStep`. */
function measured(name: string, program: CardProgram): number {
  const blocks = blocksOf(program)
  const network = blocks.find(({ type }) => type === 'ai_neural_network')
  const brain = network && program.brains[network.id]
  if (name === 'knobs')
    return Object.values(brain?.weights ?? {})
      .flatMap((to) => Object.values(to))
      .filter(Boolean).length
  if (name === 'examples') return brain?.examples?.rows.length ?? 0
  if (name === 'rounds') return brain?.practice?.round ?? 0
  const road = /^(\d+)-(\d+)$/.exec(name)
  if (road)
    return blocks.filter(({ fields }) => fields?.['FROM'] === road[1] && fields?.['TO'] === road[2]).length
  if (!name.startsWith('#')) return blocks.filter(({ type }) => type.startsWith(name)).length
  const [number] = Object.values(blocks.find(({ id }) => id === name.slice(1))?.fields ?? {})
  return Number(number ?? 0)
}

const isFollowed = (step: HintStep, program: CardProgram) =>
  Object.entries(step).every(([name, least]) => measured(name, program) >= least)

/**
 * The hint that is due for a program: the first one whose step is missing. A step of null counts as followed when a later
 * step is.
 * @param steps the card's `hintSteps`; undefined: none
 * @returns index of the hint, from 0 to the number of steps
 */
export function hintDue(steps: readonly (HintStep | null)[] | undefined, program: CardProgram): number {
  const followed = (steps ?? []).map((step) => step && isFollowed(step, program))
  const last = followed.lastIndexOf(true)
  const missing = followed.indexOf(false)
  return missing >= 0 && missing < last ? missing : last + 1
}
