import { settingsOf, type Setting } from '@botgarten/experiments/sweep'
import { CallError } from '../errors.ts'
import { decayOf } from '../learn-options.ts'

/** Lists of the call, comma between values: every combination is one setting. */
export const listOptions = {
  alpha: { type: 'string' },
  gamma: { type: 'string' },
  nu: { type: 'string' },
  rho: { type: 'string' },
  'alpha-decay': { type: 'string' },
  'rho-decay': { type: 'string' },
} as const

type Given = { readonly [name in keyof typeof listOptions]?: string }

export const settingsIn = (given: Given): Setting[] =>
  settingsOf({
    alpha: numbersIn('alpha', given.alpha ?? '0.5'),
    gamma: numbersIn('gamma', given.gamma ?? '0.8'),
    nu: numbersIn('nu', given.nu ?? '0.1'),
    rho: numbersIn('rho', given.rho ?? '0.5'),
    alphaDecay: decaysIn('alpha-decay', given['alpha-decay'] ?? ''),
    rhoDecay: decaysIn('rho-decay', given['rho-decay'] ?? ''),
  })

const numbersIn = (name: string, text: string) =>
  listOf(text).map((text) => {
    const value = Number(text)
    if (text === '' || !(value >= 0 && value <= 1)) throw new CallError('call.shares', { name, text })
    return value
  })

const decaysIn = (name: 'alpha-decay' | 'rho-decay', text: string) =>
  listOf(text).map((text) => {
    if (text !== '') decayOf(name, text)
    return text
  })

const listOf = (text: string) => text.split(',').map((one) => one.trim())
