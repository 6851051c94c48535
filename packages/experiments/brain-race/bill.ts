import type { Block } from '@botgarten/blocks'
import type { Brain } from '@botgarten/learning/neural-network'
import { headOfRow, place, type Examples } from '@botgarten/learning/neural-network/examples'
import { biasOf, weightOf, weightsOf } from '@botgarten/learning/neural-network/brain'
import type { TableBrain } from '@botgarten/learning/q-senses'
import type { Effort, Program } from '@botgarten/programs'
import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { childrenOf, sizeOf } from './blocks.ts'
import type { LaneKind, Racer } from './types.ts'

/** What a brain has cost, counted from what it is; null: this kind of brain has no such line. */
export interface Bill {
  /** Links and biases that are not 0 · values of a table that were tried · blocks in the loop. */
  readonly parts: number
  readonly examples: { readonly on: number; readonly aside: number; readonly seconds: number } | null
  /** Rounds of practice, times examples. */
  readonly practised: { readonly rounds: number; readonly examples: number } | null
  /** Decisions while it tried, and simulated minutes. */
  readonly tried: { readonly decisions: number; readonly minutes: number } | null
  /** What the lab has counted while it came about, as far as that is known; null: nothing is. */
  readonly effort: Partial<Effort> | null
}

/** @throws TypeError for a racer without a program */
export function billOf(kind: LaneKind, racer: Racer): Bill {
  return { ...partsOf(kind, racer), effort: racer.effort ?? null }
}

function partsOf(kind: LaneKind, { programs, brains, tables }: Racer): Omit<Bill, 'effort'> {
  const program = Object.values(programs)[0]
  if (!program) throw new TypeError('A racer has a program.')
  const brain = Object.values(brains)[0]
  const table = kind === 'trying' ? Object.values(tables ?? {})[0] : undefined
  if (table) return { parts: triedIn(table), examples: null, practised: null, tried: effortOf(table) }
  const isNet = kind === 'hand' || kind === 'examples'
  const parts = isNet && brain ? knobsOf(brain) : blocksInLoops(program)
  const examples = kind === 'examples' && brain?.examples ? countedIn(brain.examples) : null
  const rounds = brain?.practice?.round ?? 0
  return { parts, examples, practised: examples && { rounds, examples: examples.on }, tried: null }
}

const triedIn = ({ tries }: TableBrain): number => tries.filter((count) => count > 0).length

const effortOf = ({ moves, hold }: TableBrain): Bill['tried'] => ({
  decisions: moves,
  minutes: (moves * hold) / (60 * TICKS_PER_SECOND),
})

/** Links and biases that are not 0. */
function knobsOf(brain: Brain): number {
  const weights = weightsOf(brain, '')
  let knobs = 0
  brain.layers.slice(1).forEach((layer, index) => {
    for (const to of layer) {
      knobs += brain.layers[index]!.filter(({ id }) => weightOf(weights, id, to.id) !== 0).length
      if (biasOf(weights, to) !== 0) knobs++
    }
  })
  return knobs
}

const isLoop = ({ type }: Block) => type === 'robControls_loopForever' || type === 'controls_whileUntil'

/** All blocks in the outermost loops; of a program without one all blocks. */
function blocksInLoops({ stacks }: Program): number {
  const all = stacks.flatMap(({ blocks }) => blocks)
  const loops = all.filter((block) => !block.disabled && isLoop(block))
  const counted = loops.length > 0 ? loops.flatMap(childrenOf) : all
  return counted.reduce((sum, block) => sum + sizeOf(block), 0)
}

/** Rows that are on and set aside, and how long the drives took that they come from. */
function countedIn({ rows, drives }: Examples): NonNullable<Bill['examples']> {
  const on = rows.filter((row) => row.length >= headOfRow && row[place.on] === 1).length
  const seconds = drives.reduce((sum, { by }, drive) => {
    const ticks = rows.filter((row) => row[place.drive] === drive).map((row) => row[place.tick] ?? 0)
    return by === 'hand' || ticks.length === 0 ? sum : sum + Math.max(...ticks) - Math.min(...ticks)
  }, 0)
  return { on, aside: rows.length - on, seconds: seconds / TICKS_PER_SECOND }
}
