import type { Template } from '../types.ts'
import { number, show } from './examples.ts'

export { start } from './examples.ts'

export const colourReading: Template = { type: 'ai_sorting_collect', fields: { SENSORPORT: '1' } }

export const find = (groups: number): Template => ({
  type: 'ai_sorting_find',
  values: { GROUPS: number(groups) },
})

export const groupAs = (as: 'NUMBER' | 'NAME'): Template => ({
  type: 'ai_sorting_group',
  fields: { AS: as, SENSORPORT: '1' },
})

/** Shows the group of what the sensor sees. */
export const showGroup: Template = show(groupAs('NUMBER'))
