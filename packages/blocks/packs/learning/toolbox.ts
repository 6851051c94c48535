import { hiddenLayer, number, text } from '../../parts/examples.ts'
import {
  barrier,
  drawWay,
  follower,
  gainExperience,
  learner,
  learningMap,
} from '../../parts/learning-examples.ts'
import { act, can, chip, notice, pay, tryFor } from '../../parts/trying-examples.ts'
import { error, forget, practise, remember } from '../../parts/teaching-examples.ts'
import { colourReading, find, groupAs } from '../../parts/sorting-examples.ts'
import { withRest, type ToolboxCategory } from '../../toolbox.ts'
import type { Template } from '../../types.ts'
import { blocks } from './blocks.ts'

const trying: readonly Template[] = [learningMap(), learner, gainExperience, drawWay, follower, barrier(2, 3)]

const bySenses: readonly Template[] = [
  notice('2'),
  can,
  chip,
  pay('AHEAD', 1),
  pay('BUMP', -5),
  tryFor(8),
  act,
]

const sorting: readonly Template[] = [
  colourReading,
  find(3),
  groupAs('NUMBER'),
  groupAs('NAME'),
  { type: 'ai_sorting_near', fields: { SENSORPORT: '1' }, values: { GROUP: number(1) } },
  { type: 'ai_sorting_name', values: { GROUP: number(1), NAME: text('') } },
]

const teaching: readonly Template[] = [remember, practise(60), error, forget('EXAMPLES')]

const presets: readonly ToolboxCategory[] = [
  { category: 'network', blocks: [hiddenLayer(3), ...teaching] },
  { category: 'q-learning', blocks: [...trying, ...bySenses] },
  { category: 'sorting', blocks: sorting },
]

/** What a child finds of them. */
export const learningToolbox = withRest(presets, blocks)
