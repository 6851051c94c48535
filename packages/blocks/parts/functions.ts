import { whole, type Expression, type PythonAt } from '../python.ts'
import type { Block, Definition, Next } from '../types.ts'
import { ask, done, give } from './next.ts'

const nameOf = (block: Block): string => block.mutation?.attrs.name ?? ''

const questions: Next[] = []

function askArg(k: number): Next {
  while (questions.length <= k) questions.push(ask(`ARG${questions.length}`))
  return questions[k] ?? done
}

/** Asks for every argument, calls the function, and hands up what it gives. */
export const askArgs: Definition['run'] = (block, frame) => {
  const count = block.mutation?.args?.length ?? 0
  const stage = frame.stage++
  if (stage < count) return askArg(stage)
  if (stage === count) return { next: 'call', name: nameOf(block), args: [...frame.got] }
  return give(frame.got[count] ?? null)
}

/** A call of a function of the program. */
export function calls(py: PythonAt): Expression {
  const count = py.block.mutation?.args?.length ?? 0
  const args = Array.from({ length: count }, (_, k) => py.value(`ARG${k}`))
  return whole(`${py.func(nameOf(py.block))}(${args.join(', ')})`)
}
