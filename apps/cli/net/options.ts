import type { Brain } from '@botgarten/learning/neural-network'
import { mirrorIn, hiddenActivations, type Hidden } from '@botgarten/programs/examples'
import { practiceChoice, stepSettings, type Exercise } from '@botgarten/learning/neural-network/examples'
import type { Settings } from '@botgarten/learning/neural-network/train'
import { CallError } from '../errors.ts'
import { numberIn, oneOf, wholeNumberIn } from '../options.ts'
import type { Source } from './source.ts'

export const known = {
  solution: { type: 'boolean' },
  examples: { type: 'string' },
  brain: { type: 'string' },
  rounds: { type: 'string' },
  rate: { type: 'string' },
  momentum: { type: 'string' },
  adam: { type: 'boolean' },
  batch: { type: 'string' },
  decay: { type: 'string' },
  bias: { type: 'boolean' },
  'no-bias': { type: 'boolean' },
  mirror: { type: 'boolean' },
  'no-mirror': { type: 'boolean' },
  hidden: { type: 'string' },
  from: { type: 'string' },
  'keep-back': { type: 'string' },
  seed: { type: 'string' },
  seeds: { type: 'string' },
  out: { type: 'string' },
  notebook: { type: 'string' },
  json: { type: 'boolean' },
} as const

type Given = { readonly [name in keyof typeof known]?: string | boolean }
type Text = {
  readonly [name in 'rounds' | 'rate' | 'momentum' | 'batch' | 'decay' | 'from' | 'keep-back']?: string
}
export type Values = Given & Text & { readonly hidden?: string }

/** What was chosen or practised last is the preset, else the starter's. */
export function settingsOf(values: Values, brain: Brain): Settings {
  const preset = stepSettings(practiceChoice(brain))
  const { momentum, decay, rate, batch, rounds } = preset
  return {
    ...{ range: preset.range, order: preset.order, patience: preset.patience },
    rate: numberIn('rate', values.rate, rate, 0.0001, 5),
    momentum: numberIn('momentum', values.momentum, momentum, 0, 0.999),
    decay: numberIn('decay', values.decay, decay, 0, 1),
    batch: wholeNumberIn('batch', values.batch, batch, 1, 10_000),
    rounds: wholeNumberIn('rounds', values.rounds, rounds, 1, 100_000),
    optimizer: values.adam ? 'adam' : preset.optimizer,
    bias: switched(values, 'bias', preset.bias === 'on') ? 'on' : 'off',
  }
}

/** `--name` switches on, `--no-name` off. */
function switched(values: Values, name: 'bias' | 'mirror', preset: boolean): boolean {
  if (values[name] && values[`no-${name}`]) throw new CallError('call.onAndOff', { name })
  return values[name] === true || (preset && values[`no-${name}`] !== true)
}

type Beginning = Pick<Exercise, 'keepBack' | 'from' | 'mirror'>

export function beginningOf(values: Values, { brain, network, config }: Source): Beginning {
  const preset = practiceChoice(brain).settings
  const mirror = mirrorIn(network, config)
  if (values.mirror && !mirror) throw new CallError('call.noMirror')
  const from =
    values.from === undefined ? preset.from : oneOf('from', values.from, ['knobs', 'zero'] as const)
  return {
    keepBack: numberIn('keep-back', values['keep-back'], preset.keepBack, 0, 1),
    from,
    mirror: switched(values, 'mirror', preset.mirror) ? mirror : null,
  }
}

/** Layers such as `4:tanh` with commas between, from the inputs on; tanh where none is named. */
export function hiddenOf(text: string): readonly Hidden[] {
  return text.split(',').map((layer) => {
    const [, neurons, name = 'tanh'] = /^(\d{1,2})(?::(\w+))?$/.exec(layer.trim()) ?? []
    if (neurons === undefined || !(Number(neurons) >= 1 && Number(neurons) <= 64) || !isActivation(name))
      throw new CallError('call.hidden', { text: layer })
    return { neurons: Number(neurons), activation: name }
  })
}

const isActivation = (name: string): name is Hidden['activation'] => Object.hasOwn(hiddenActivations, name)
