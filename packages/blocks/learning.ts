// Blocks for deeper networks, for learning by trying and for sorting: brought before a program that uses them is opened.
import { knowCurves } from '@botgarten/learning/neural-network'
import { curves } from '@botgarten/learning/neural-network/curves'
import { ai_nn_hidden_layer } from './network/ai_nn_hidden_layer.ts'
import { hiddenLayer, number, text } from './parts/examples.ts'
import {
  barrier,
  drawWay,
  follower,
  gainExperience,
  learner,
  learningMap,
} from './parts/learning-examples.ts'
import { colourReading, find, groupAs } from './parts/sorting-examples.ts'
import { ai_q_apply_learning_rule } from './q-learning/ai_q_apply_learning_rule.ts'
import { ai_q_barrier_mountain } from './q-learning/ai_q_barrier_mountain.ts'
import { ai_q_draw_the_best_way } from './q-learning/ai_q_draw_the_best_way.ts'
import { ai_q_drive_the_best_way } from './q-learning/ai_q_drive_the_best_way.ts'
import { ai_q_learner_config } from './q-learning/ai_q_learner_config.ts'
import { ai_q_learning_states_and_actions_map } from './q-learning/ai_q_learning_states_and_actions_map.ts'
import { rl_obstacles_easy_list } from './q-learning/rl_obstacles_easy_list.ts'
import { ai_sorting_collect } from './sorting/ai_sorting_collect.ts'
import { ai_sorting_find } from './sorting/ai_sorting_find.ts'
import { ai_sorting_group } from './sorting/ai_sorting_group.ts'
import { ai_sorting_name } from './sorting/ai_sorting_name.ts'
import { ai_sorting_near } from './sorting/ai_sorting_near.ts'
import type { LearningType } from './block-type.ts'
import type { ToolboxCategory } from './toolbox.ts'
import type { Definition, Template } from './types.ts'

// Whoever knows deeper networks knows all that their neurons do.
knowCurves(curves)

export const learning: { readonly [T in LearningType]: Definition } = {
  ai_nn_hidden_layer,
  ai_q_apply_learning_rule,
  ai_q_barrier_mountain,
  ai_q_draw_the_best_way,
  ai_q_drive_the_best_way,
  ai_q_learner_config,
  ai_q_learning_states_and_actions_map,
  rl_obstacles_easy_list,
  ai_sorting_collect,
  ai_sorting_find,
  ai_sorting_group,
  ai_sorting_name,
  ai_sorting_near,
}

const trying: readonly Template[] = [learningMap(), learner, gainExperience, drawWay, follower, barrier(2, 3)]

const sorting: readonly Template[] = [
  colourReading,
  find(3),
  groupAs('NUMBER'),
  groupAs('NAME'),
  { type: 'ai_sorting_near', fields: { SENSORPORT: '1' }, values: { GROUP: number(1) } },
  { type: 'ai_sorting_name', values: { GROUP: number(1), NAME: text('') } },
]

/** What a child finds of them. */
export const learningToolbox: readonly ToolboxCategory[] = [
  { category: 'network', blocks: [hiddenLayer(3)] },
  { category: 'q-learning', blocks: trying },
  { category: 'sorting', blocks: sorting },
]
