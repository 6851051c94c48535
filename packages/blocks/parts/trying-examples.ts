import type { Template } from '../types.ts'
import { forever, start } from './examples.ts'

export const notice = (port: string): Template => ({
  type: 'ai_try_senses',
  fields: { SENSE: 'DISTANCE', SENSORPORT: port, LOW: '15', HIGH: '40' },
})
export const can: Template = {
  type: 'ai_try_actions',
  fields: { CHIP1: 'AHEAD', CHIP2: 'LEFT', CHIP3: 'RIGHT', CHIP4: 'NONE', HOLD: '15' },
}
export const pay = (what: string, coins: number): Template => ({
  type: 'ai_try_pay',
  fields: { WHAT: what, COINS: String(coins) },
})
export const tryFor = (minutes: number): Template => ({
  type: 'ai_try_learn',
  fields: { MINUTES: String(minutes) },
})
export const chip: Template = { type: 'ai_try_chip', fields: { LEFT: '60', RIGHT: '30', LAMP: 'NONE' } }
export const act: Template = { type: 'ai_try_act' }

/** Two eyes, three actions, pay for the way and for bumps; then forever the best it knows. */
export const tryProgram = (minutes = 1): readonly Template[] => [
  ...[start, notice('2'), notice('3'), can, pay('AHEAD', 1), pay('BUMP', -5), tryFor(minutes)],
  forever(act),
]

/** The same with a curve of one's own. */
export const chipProgram = (): readonly Template[] =>
  tryProgram().flatMap((block) => (block === can ? [block, chip] : [block]))
