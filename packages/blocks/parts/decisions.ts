import type { Definition, Next } from '../types.ts'
import { ask, carryOut, done } from './next.ts'

const condition = ask('IF0')
const then = carryOut('DO0')

/** Asks for the condition, carries out one of the two ways, and is done. `otherwise`: what happens when it is not true. */
export const decide =
  (otherwise: Next): Definition['run'] =>
  (_block, frame) => {
    const stage = frame.stage++
    if (stage === 0) return condition
    if (stage === 1) return frame.got[0] === true ? then : otherwise
    return done
  }
