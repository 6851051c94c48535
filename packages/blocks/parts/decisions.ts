import type { Python, PythonAt } from '../python.ts'
import type { Definition, Next } from '../types.ts'
import { ask, execute, done } from './next.ts'

interface Way {
  readonly ask: Next
  readonly execute: Next
}

const ways: Way[] = []

function wayAt(k: number): Way {
  while (ways.length <= k) ways.push({ ask: ask(`IF${ways.length}`), execute: execute(`DO${ways.length}`) })
  return ways[k] ?? { ask: done, execute: done }
}

/**
 * Asks its conditions (mutation `elseif`: how many more than one) until one is true, executes that way, and is done.
 * `otherwise`: what happens when none is true.
 */
export const decide =
  (otherwise: Next): Definition['run'] =>
  (block, frame) => {
    const asked = frame.stage
    if (asked < 0) return done
    const holds = asked > 0 && frame.got[asked - 1] === true
    if (!holds && asked < 1 + (Number(block.mutation?.attrs.elseif) || 0)) {
      frame.stage++
      return wayAt(asked).ask
    }
    frame.stage = -1
    return holds ? wayAt(asked - 1).execute : otherwise
  }

/** `if`, `elif`, and `else` where the block has one. */
export const decision = (otherwise: boolean): Python => decided(otherwise, 'if')

const conditionsOf = (py: PythonAt): readonly string[] =>
  Array.from({ length: 1 + (Number(py.block.mutation?.attrs.elseif) || 0) }, (_, k) => py.value(`IF${k}`))

/** What decides alone where the other one ends goes on as `elif`. */
const decided = (otherwise: boolean, first: string) => (py: PythonAt) => {
  conditionsOf(py).forEach((condition, k) => py.rows(`${k === 0 ? first : 'elif'} ${condition}:`, `DO${k}`))
  if (!otherwise) return
  const inner = py.alone('ELSE', ['robControls_if', 'robControls_ifElse'], conditionsOf)
  if (inner) decided(inner.block.type === 'robControls_ifElse', 'elif')(inner)
  else py.rows('else:', 'ELSE')
}
