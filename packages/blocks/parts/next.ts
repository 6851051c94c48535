import type { Facts, Next, Value } from '../types.ts'

/** Answers that never change are made once: the interpreter's hot path allocates as little as it can. */
export const done: Next = Object.freeze({ next: 'done' })
export const again: Next = Object.freeze({ next: 'again' })
export const wait: Next = Object.freeze({ next: 'wait' })

/** The value of a value block. */
export const give = (value: Value): Next => ({ next: 'done', value })

export const ask = (input: string): Next => Object.freeze({ next: 'value', input })
export const execute = (input: string): Next => Object.freeze({ next: 'statements', input })

/** `name`: the problem's name in the section `problem` of the words. */
export const fail = (name: string, facts?: Facts): Next => ({
  next: 'fail',
  problem: `problem.${name}`,
  facts,
})
