import type { ExpertType } from './block-type.ts'
import { controls_repeat } from './control/controls_repeat.ts'
import { controls_whileUntil } from './control/controls_whileUntil.ts'
import { controls_flow_statements } from './control/controls_flow_statements.ts'
import { robControls_for } from './control/robControls_for.ts'
import { robControls_forEach } from './control/robControls_forEach.ts'
import { robControls_wait } from './control/robControls_wait.ts'
import { robControls_wait_for } from './control/robControls_wait_for.ts'
import { text_comment } from './control/text_comment.ts'
import { robActions_motor_on_for } from './action/robActions_motor_on_for.ts'
import { robActions_motor_getPower } from './action/robActions_motor_getPower.ts'
import { robActions_motor_setPower } from './action/robActions_motor_setPower.ts'
import { robActions_motor_stop } from './action/robActions_motor_stop.ts'
import { robActions_motorDiff_curve } from './action/robActions_motorDiff_curve.ts'
import { robActions_motorDiff_curve_for } from './action/robActions_motorDiff_curve_for.ts'
import { robActions_display_picture_new } from './action/robActions_display_picture_new.ts'
import { robActions_display_picture } from './action/robActions_display_picture.ts'
import { mbedActions_play_note } from './action/mbedActions_play_note.ts'
import { robActions_play_file } from './action/robActions_play_file.ts'
import { robActions_play_setVolume } from './action/robActions_play_setVolume.ts'
import { robActions_play_getVolume } from './action/robActions_play_getVolume.ts'
import { robActions_setLanguage } from './action/robActions_setLanguage.ts'
import { robActions_sayText } from './action/robActions_sayText.ts'
import { robActions_sayText_parameters } from './action/robActions_sayText_parameters.ts'
import { robActions_brickLight_on } from './action/robActions_brickLight_on.ts'
import { robActions_brickLight_off } from './action/robActions_brickLight_off.ts'
import { robActions_brickLight_reset } from './action/robActions_brickLight_reset.ts'
import { robActions_assert } from './action/robActions_assert.ts'
import { robActions_debug } from './action/robActions_debug.ts'
import { robSensors_compass_calibrate } from './sensors/robSensors_compass_calibrate.ts'
import { robSensors_irseeker_getSample } from './sensors/robSensors_irseeker_getSample.ts'
import { robSensors_htcolour_getSample } from './sensors/robSensors_htcolour_getSample.ts'
import { robSensors_getSample } from './sensors/robSensors_getSample.ts'
import { logic_operation } from './logic/logic_operation.ts'
import { logic_negate } from './logic/logic_negate.ts'
import { logic_boolean } from './logic/logic_boolean.ts'
import { logic_null } from './logic/logic_null.ts'
import { logic_ternary } from './logic/logic_ternary.ts'
import { math_single } from './math/math_single.ts'
import { math_trig } from './math/math_trig.ts'
import { math_constant } from './math/math_constant.ts'
import { math_number_property } from './math/math_number_property.ts'
import { robMath_change } from './math/robMath_change.ts'
import { math_round } from './math/math_round.ts'
import { math_on_list } from './math/math_on_list.ts'
import { math_modulo } from './math/math_modulo.ts'
import { math_constrain } from './math/math_constrain.ts'
import { math_random_int } from './math/math_random_int.ts'
import { math_random_float } from './math/math_random_float.ts'
import { math_cast_toString } from './math/math_cast_toString.ts'
import { math_cast_toChar } from './math/math_cast_toChar.ts'
import { robText_join } from './text/robText_join.ts'
import { robText_append } from './text/robText_append.ts'
import { text_cast_string_toNumber } from './text/text_cast_string_toNumber.ts'
import { text_cast_char_toNumber } from './text/text_cast_char_toNumber.ts'
import { robActions_eval_expr } from './text/robActions_eval_expr.ts'
import { robActions_eval_stmt } from './text/robActions_eval_stmt.ts'
import { robLists_create_with } from './lists/robLists_create_with.ts'
import { robLists_repeat } from './lists/robLists_repeat.ts'
import { robLists_length } from './lists/robLists_length.ts'
import { robLists_isEmpty } from './lists/robLists_isEmpty.ts'
import { robLists_indexOf } from './lists/robLists_indexOf.ts'
import { robLists_getIndex } from './lists/robLists_getIndex.ts'
import { robLists_setIndex } from './lists/robLists_setIndex.ts'
import { robLists_getSublist } from './lists/robLists_getSublist.ts'
import { robGlobalVariables_declare } from './variables/robGlobalVariables_declare.ts'
import { robLocalVariables_declare } from './variables/robLocalVariables_declare.ts'
import { variables_get } from './variables/variables_get.ts'
import { variables_set } from './variables/variables_set.ts'
import { robProcedures_defnoreturn } from './functions/robProcedures_defnoreturn.ts'
import { robProcedures_defreturn } from './functions/robProcedures_defreturn.ts'
import { robProcedures_callnoreturn } from './functions/robProcedures_callnoreturn.ts'
import { robProcedures_callreturn } from './functions/robProcedures_callreturn.ts'
import { robProcedures_ifreturn } from './functions/robProcedures_ifreturn.ts'
import { robCommunication_startConnection } from './messages/robCommunication_startConnection.ts'
import { robCommunication_sendBlock } from './messages/robCommunication_sendBlock.ts'
import { robCommunication_receiveBlock } from './messages/robCommunication_receiveBlock.ts'
import { robCommunication_waitForConnection } from './messages/robCommunication_waitForConnection.ts'
import { robActions_NNstep } from './network/robActions_NNstep.ts'
import { robActions_set_inputneuron_val } from './network/robActions_set_inputneuron_val.ts'
import { robSensors_get_outputneuron_val } from './network/robSensors_get_outputneuron_val.ts'
import { robActions_set_weight } from './network/robActions_set_weight.ts'
import { robActions_set_bias } from './network/robActions_set_bias.ts'
import { robSensors_get_weight } from './network/robSensors_get_weight.ts'
import { robSensors_get_bias } from './network/robSensors_get_bias.ts'
import { robActions_inputneuron } from './network/robActions_inputneuron.ts'
import { robActions_outputneuron } from './network/robActions_outputneuron.ts'
import { robActions_outputneuron_wo_var } from './network/robActions_outputneuron_wo_var.ts'
import { robActions_change_weight } from './network/robActions_change_weight.ts'
import { robActions_change_bias } from './network/robActions_change_bias.ts'
import { actions_bricklight_off_ev3 } from './richer/actions_bricklight_off_ev3.ts'
import { actions_bricklight_on_ev3 } from './richer/actions_bricklight_on_ev3.ts'
import { math_arithmetic } from './richer/math_arithmetic.ts'
import { robSensors_colour_getSample } from './richer/robSensors_colour_getSample.ts'
import { robSensors_infrared_getSample } from './richer/robSensors_infrared_getSample.ts'
import { robSensors_ultrasonic_getSample } from './richer/robSensors_ultrasonic_getSample.ts'
import { learning } from './learning.ts'
import type { Definition } from './types.ts'

/** The rest of the language; a name of `ExpertType` without its definition does not compile. */
const more: { readonly [T in ExpertType]: Definition } = {
  controls_repeat,
  controls_whileUntil,
  controls_flow_statements,
  robControls_for,
  robControls_forEach,
  robControls_wait,
  robControls_wait_for,
  text_comment,
  robActions_motor_on_for,
  robActions_motor_getPower,
  robActions_motor_setPower,
  robActions_motor_stop,
  robActions_motorDiff_curve,
  robActions_motorDiff_curve_for,
  robActions_display_picture_new,
  robActions_display_picture,
  mbedActions_play_note,
  robActions_play_file,
  robActions_play_setVolume,
  robActions_play_getVolume,
  robActions_setLanguage,
  robActions_sayText,
  robActions_sayText_parameters,
  robActions_brickLight_on,
  robActions_brickLight_off,
  robActions_brickLight_reset,
  robActions_assert,
  robActions_debug,
  robSensors_compass_calibrate,
  robSensors_irseeker_getSample,
  robSensors_htcolour_getSample,
  robSensors_getSample,
  logic_operation,
  logic_negate,
  logic_boolean,
  logic_null,
  logic_ternary,
  math_single,
  math_trig,
  math_constant,
  math_number_property,
  robMath_change,
  math_round,
  math_on_list,
  math_modulo,
  math_constrain,
  math_random_int,
  math_random_float,
  math_cast_toString,
  math_cast_toChar,
  robText_join,
  robText_append,
  text_cast_string_toNumber,
  text_cast_char_toNumber,
  robActions_eval_expr,
  robActions_eval_stmt,
  robLists_create_with,
  robLists_repeat,
  robLists_length,
  robLists_isEmpty,
  robLists_indexOf,
  robLists_getIndex,
  robLists_setIndex,
  robLists_getSublist,
  robGlobalVariables_declare,
  robLocalVariables_declare,
  variables_get,
  variables_set,
  robProcedures_defnoreturn,
  robProcedures_defreturn,
  robProcedures_callnoreturn,
  robProcedures_callreturn,
  robProcedures_ifreturn,
  robCommunication_startConnection,
  robCommunication_sendBlock,
  robCommunication_receiveBlock,
  robCommunication_waitForConnection,
  robActions_NNstep,
  robActions_set_inputneuron_val,
  robSensors_get_outputneuron_val,
  robActions_set_weight,
  robActions_set_bias,
  robSensors_get_weight,
  robSensors_get_bias,
  robActions_inputneuron,
  robActions_outputneuron,
  robActions_outputneuron_wo_var,
  robActions_change_weight,
  robActions_change_bias,
}

/** Fuller looks of blocks that the cards have in a plain one. */
const richer = {
  actions_bricklight_off_ev3,
  actions_bricklight_on_ev3,
  math_arithmetic,
  robSensors_colour_getSample,
  robSensors_infrared_getSample,
  robSensors_ultrasonic_getSample,
}

/** All that the cards do not need at once, the learning pack included. */
export const expert: { readonly [type: string]: Definition } = { ...learning, ...more, ...richer }
