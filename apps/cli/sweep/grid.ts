import type { Settings } from '@botgarten/learning/q-learning'
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

/** One row of the sweep: what was given, as it was given. */
export interface Setting {
  readonly alpha: number
  readonly gamma: number
  readonly nu: number
  readonly rho: number
  readonly alphaDecay?: string
  readonly rhoDecay?: string
}

/** All combinations; the last list turns fastest. */
export function settingsIn(given: Given): Setting[] {
  const numbers = (name: 'alpha' | 'gamma' | 'nu' | 'rho', preset: string) =>
    listOf(given[name] ?? preset).map((text) => {
      const value = Number(text)
      if (text === '' || !(value >= 0 && value <= 1)) throw new CallError('call.shares', { name, text })
      return value
    })
  const decays = (name: 'alpha-decay' | 'rho-decay') =>
    listOf(given[name] ?? '').map((text) => {
      if (text !== '') decayOf(name, text)
      return text
    })
  const all: Setting[] = []
  for (const alpha of numbers('alpha', '0.5'))
    for (const gamma of numbers('gamma', '0.8'))
      for (const nu of numbers('nu', '0.1'))
        for (const rho of numbers('rho', '0.5'))
          for (const alphaDecay of decays('alpha-decay'))
            for (const rhoDecay of decays('rho-decay'))
              all.push({
                ...{ alpha, gamma, nu, rho },
                ...(alphaDecay === '' ? {} : { alphaDecay }),
                ...(rhoDecay === '' ? {} : { rhoDecay }),
              })
  return all
}

const listOf = (text: string) => text.split(',').map((one) => one.trim())

/** A setting's own name: streams hang on it, so that more settings change no run of another. */
export const nameOf = (setting: Setting): string => JSON.stringify(setting)

export function learnerSettings(
  { alpha, gamma, nu, rho, alphaDecay, rhoDecay }: Setting,
  { rules, algorithm }: Pick<Settings, 'rules' | 'algorithm'>,
): Settings {
  return {
    ...{ rules, algorithm, alpha, gamma, nu, rho },
    alphaDecay: decayOf('alpha-decay', alphaDecay),
    rhoDecay: decayOf('rho-decay', rhoDecay),
  }
}
