import { limits, racers, type Lane, type Racer } from '@botgarten/experiments/race'
import { CallError } from '../errors.ts'

const usual = { alpha: 0.5, gamma: 0.8, nu: 0, rho: 0.1 }

/** Where a call names none: one of each. */
const preset = racers.join(',')

/** `q:rho=.5:alpha=.1,sarsa,best,random`: racers with their settings. */
export function lanesIn(text = preset): Lane[] {
  const lanes = text.split(',').map((lane) => laneIn(lane.trim()))
  if (lanes.length < limits.lanes.least || lanes.length > limits.lanes.most)
    throw new CallError('call.lanes', { count: lanes.length })
  return lanes
}

function laneIn(text: string): Lane {
  const [name, ...set] = text.split(':')
  if (!isRacer(name)) throw new CallError('call.racer', { text, racers: racers.join(', ') })
  return { racer: name, ...usual, ...Object.fromEntries(set.map((one) => settingIn(one, text))) }
}

const isRacer = (name: string | undefined): name is Racer => racers.some((racer) => racer === name)

function settingIn(text: string, lane: string): readonly [string, number] {
  const [name = '', value = ''] = text.split('=')
  const number = Number(value)
  if (!Object.hasOwn(usual, name) || value === '' || !(number >= 0 && number <= 1))
    throw new CallError('call.laneSetting', { text, lane })
  return [name, number]
}
