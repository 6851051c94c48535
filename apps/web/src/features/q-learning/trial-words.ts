import type { LearnedRun } from '@botgarten/programs'
import { say } from '#words/say.ts'
import type { Level } from './levels.ts'
import { number } from './numbers.ts'

/** What can be set, in the order of the card's table. */
export const settings = ['alpha', 'gamma', 'nu', 'rho'] as const
type Setting = (typeof settings)[number]

const choices: { readonly [name in Setting]: { readonly [value: string]: string } } = {
  alpha: { 0.1: 'slowly', 0.5: 'medium', 0.9: 'fast' },
  gamma: { 0.8: 'aLot', 0.2: 'aLittle' },
  nu: { 0.1: 'rarely', 0.9: 'often' },
  rho: { 0.9: 'rarely', 0.5: 'sometimes', 0.1: 'often' },
}

/** A setting as its block says it; a number where no block says it so, and for experts. */
export function settingOf(run: LearnedRun, name: Setting, level: Level): string {
  const key = choices[name][String(run[name])]
  return level === 'expert' || key === undefined ? number(run[name], 4) : say(`choice.${key}`)
}

export const wayOf = (text: string) => text.replaceAll('-', ' → ')

/** What was guessed, with a tick where it was right; '' where nothing was. */
export const guessOf = ({ guess, way }: LearnedRun) =>
  way !== '' && guess.match(/\d+/g)?.join('-') === way ? `${guess} ✓` : guess
