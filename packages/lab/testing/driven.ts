import type { Robot } from '@botgarten/blocks'
import type { Program } from '@botgarten/programs'
import { createSimulation, type Floor } from '@botgarten/simulation'
import { results } from '../checks/checks.ts'
import { Run } from '../run.ts'
import type { Check, Document } from '../types.ts'
import { viewOf } from '../view.ts'

/** A program that never ends and does nothing. */
const idle: Program = {
  stacks: [
    {
      ...{ x: 0, y: 0 },
      blocks: [
        { id: 'start', type: 'robControls_start' },
        {
          ...{ id: 'forever', type: 'robControls_loopForever' },
          statements: {
            DO: [
              {
                ...{ id: 'wait', type: 'robControls_wait_time' },
                values: { WAIT: { id: 'ms', type: 'math_number', fields: { NUM: '1000' } } },
              },
            ],
          },
        },
      ],
    },
  ],
  config: { stacks: [] },
}

/** The program does nothing, but has the map block, since checks read which roads are closed. */
function idleOf({ stacks }: Program): Program {
  const map = stacks
    .flatMap(({ blocks }) => blocks)
    .filter(({ type }) => type === 'ai_q_learning_states_and_actions_map')
  return { ...idle, stacks: [...idle.stacks, ...map.map((block) => ({ x: 0, y: 200, blocks: [block] }))] }
}

/** A run whose first robot is driven from outside in place of its program. */
export function drivenRun(document: Document, floor: Floor, checks: readonly Check[], seed: number) {
  const programs = Object.fromEntries(
    Object.entries(document.programs).map(([id, program]) => [id, idleOf(program)]),
  )
  const simulation = createSimulation(document.world, floor, seed)
  const run = new Run(simulation, { ...document, programs }, checks)
  const robot: Robot = run.robots[0]!.context.robot
  return {
    robot,
    advance: () => run.advance(),
    view: () => viewOf(run, 'running', 0, false),
    results: () => results(checks, run.watches),
  }
}
