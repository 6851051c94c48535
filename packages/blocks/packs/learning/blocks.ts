// Made by `npm run blocks`.

import { ai_nn_error } from '../../network/ai_nn_error.ts'
import { ai_nn_forget } from '../../network/ai_nn_forget.ts'
import { ai_nn_hidden_layer } from '../../network/ai_nn_hidden_layer.ts'
import { ai_nn_practise } from '../../network/ai_nn_practise.ts'
import { ai_nn_remember } from '../../network/ai_nn_remember.ts'
import { ai_q_apply_learning_rule } from '../../q-learning/ai_q_apply_learning_rule.ts'
import { ai_q_barrier_mountain } from '../../q-learning/ai_q_barrier_mountain.ts'
import { ai_q_draw_the_best_way } from '../../q-learning/ai_q_draw_the_best_way.ts'
import { ai_q_drive_the_best_way } from '../../q-learning/ai_q_drive_the_best_way.ts'
import { ai_q_learner_config } from '../../q-learning/ai_q_learner_config.ts'
import { ai_q_learning_states_and_actions_map } from '../../q-learning/ai_q_learning_states_and_actions_map.ts'
import { ai_try_act } from '../../q-learning/ai_try_act.ts'
import { ai_try_actions } from '../../q-learning/ai_try_actions.ts'
import { ai_try_chip } from '../../q-learning/ai_try_chip.ts'
import { ai_try_learn } from '../../q-learning/ai_try_learn.ts'
import { ai_try_pay } from '../../q-learning/ai_try_pay.ts'
import { ai_try_senses } from '../../q-learning/ai_try_senses.ts'
import { rl_obstacles_easy_list } from '../../q-learning/rl_obstacles_easy_list.ts'
import { ai_sorting_collect } from '../../sorting/ai_sorting_collect.ts'
import { ai_sorting_find } from '../../sorting/ai_sorting_find.ts'
import { ai_sorting_group } from '../../sorting/ai_sorting_group.ts'
import { ai_sorting_name } from '../../sorting/ai_sorting_name.ts'
import { ai_sorting_near } from '../../sorting/ai_sorting_near.ts'
import type { TypeIn } from '../packs.ts'
import type { Definition } from '../../types.ts'

export const blocks: { readonly [T in TypeIn<'learning'>]: Definition } = {
  ai_nn_error,
  ai_nn_forget,
  ai_nn_hidden_layer,
  ai_nn_practise,
  ai_nn_remember,
  ai_q_apply_learning_rule,
  ai_q_barrier_mountain,
  ai_q_draw_the_best_way,
  ai_q_drive_the_best_way,
  ai_q_learner_config,
  ai_q_learning_states_and_actions_map,
  ai_try_act,
  ai_try_actions,
  ai_try_chip,
  ai_try_learn,
  ai_try_pay,
  ai_try_senses,
  rl_obstacles_easy_list,
  ai_sorting_collect,
  ai_sorting_find,
  ai_sorting_group,
  ai_sorting_name,
  ai_sorting_near,
}
