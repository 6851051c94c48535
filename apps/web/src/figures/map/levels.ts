import { message } from '#words/message.ts'

/** What can be set of a learner, in the order of a card's table. */
export const settings = ['alpha', 'gamma', 'nu', 'rho'] as const
export type Setting = (typeof settings)[number]

const choices: { readonly [name in Setting]: { readonly [value: string]: string } } = {
  alpha: { 0.1: 'slowly', 0.5: 'medium', 0.9: 'fast' },
  gamma: { 0.8: 'aLot', 0.2: 'aLittle' },
  nu: { 0.1: 'rarely', 0.9: 'often' },
  rho: { 0.9: 'rarely', 0.5: 'sometimes', 0.1: 'often' },
}

/** A setting as its block says it; null where no block says it so. Its words are those of the blocks: `blocks-q-learning`. */
export function levelWord(name: Setting, value: number): string | null {
  const key = choices[name][String(value)]
  return key === undefined ? null : message(`choice.${key}`)
}
