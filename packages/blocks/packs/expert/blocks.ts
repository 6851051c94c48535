// Made by `npm run blocks`.

import { mbedActions_play_note } from '../../action/mbedActions_play_note.ts'
import { robActions_assert } from '../../action/robActions_assert.ts'
import { robActions_brickLight_off } from '../../action/robActions_brickLight_off.ts'
import { robActions_brickLight_on } from '../../action/robActions_brickLight_on.ts'
import { robActions_brickLight_reset } from '../../action/robActions_brickLight_reset.ts'
import { robActions_debug } from '../../action/robActions_debug.ts'
import { robActions_display_picture } from '../../action/robActions_display_picture.ts'
import { robActions_display_picture_new } from '../../action/robActions_display_picture_new.ts'
import { robActions_motorDiff_curve } from '../../action/robActions_motorDiff_curve.ts'
import { robActions_motorDiff_curve_for } from '../../action/robActions_motorDiff_curve_for.ts'
import { robActions_motor_getPower } from '../../action/robActions_motor_getPower.ts'
import { robActions_motor_on_for } from '../../action/robActions_motor_on_for.ts'
import { robActions_motor_setPower } from '../../action/robActions_motor_setPower.ts'
import { robActions_motor_stop } from '../../action/robActions_motor_stop.ts'
import { robActions_play_file } from '../../action/robActions_play_file.ts'
import { robActions_play_getVolume } from '../../action/robActions_play_getVolume.ts'
import { robActions_play_setVolume } from '../../action/robActions_play_setVolume.ts'
import { robActions_sayText } from '../../action/robActions_sayText.ts'
import { robActions_sayText_parameters } from '../../action/robActions_sayText_parameters.ts'
import { robActions_setLanguage } from '../../action/robActions_setLanguage.ts'
import { controls_flow_statements } from '../../control/controls_flow_statements.ts'
import { controls_repeat } from '../../control/controls_repeat.ts'
import { controls_whileUntil } from '../../control/controls_whileUntil.ts'
import { robControls_for } from '../../control/robControls_for.ts'
import { robControls_forEach } from '../../control/robControls_forEach.ts'
import { robControls_wait } from '../../control/robControls_wait.ts'
import { robControls_wait_for } from '../../control/robControls_wait_for.ts'
import { text_comment } from '../../control/text_comment.ts'
import { robProcedures_callnoreturn } from '../../functions/robProcedures_callnoreturn.ts'
import { robProcedures_callreturn } from '../../functions/robProcedures_callreturn.ts'
import { robProcedures_defnoreturn } from '../../functions/robProcedures_defnoreturn.ts'
import { robProcedures_defreturn } from '../../functions/robProcedures_defreturn.ts'
import { robProcedures_ifreturn } from '../../functions/robProcedures_ifreturn.ts'
import { robLists_create_with } from '../../lists/robLists_create_with.ts'
import { robLists_getIndex } from '../../lists/robLists_getIndex.ts'
import { robLists_getSublist } from '../../lists/robLists_getSublist.ts'
import { robLists_indexOf } from '../../lists/robLists_indexOf.ts'
import { robLists_isEmpty } from '../../lists/robLists_isEmpty.ts'
import { robLists_length } from '../../lists/robLists_length.ts'
import { robLists_repeat } from '../../lists/robLists_repeat.ts'
import { robLists_setIndex } from '../../lists/robLists_setIndex.ts'
import { logic_boolean } from '../../logic/logic_boolean.ts'
import { logic_negate } from '../../logic/logic_negate.ts'
import { logic_null } from '../../logic/logic_null.ts'
import { logic_operation } from '../../logic/logic_operation.ts'
import { logic_ternary } from '../../logic/logic_ternary.ts'
import { math_cast_toChar } from '../../math/math_cast_toChar.ts'
import { math_cast_toString } from '../../math/math_cast_toString.ts'
import { math_constant } from '../../math/math_constant.ts'
import { math_constrain } from '../../math/math_constrain.ts'
import { math_modulo } from '../../math/math_modulo.ts'
import { math_number_property } from '../../math/math_number_property.ts'
import { math_on_list } from '../../math/math_on_list.ts'
import { math_random_float } from '../../math/math_random_float.ts'
import { math_random_int } from '../../math/math_random_int.ts'
import { math_round } from '../../math/math_round.ts'
import { math_single } from '../../math/math_single.ts'
import { math_trig } from '../../math/math_trig.ts'
import { robMath_change } from '../../math/robMath_change.ts'
import { robCommunication_receiveBlock } from '../../messages/robCommunication_receiveBlock.ts'
import { robCommunication_sendBlock } from '../../messages/robCommunication_sendBlock.ts'
import { robCommunication_startConnection } from '../../messages/robCommunication_startConnection.ts'
import { robCommunication_waitForConnection } from '../../messages/robCommunication_waitForConnection.ts'
import { robActions_NNstep } from '../../network/robActions_NNstep.ts'
import { robActions_change_bias } from '../../network/robActions_change_bias.ts'
import { robActions_change_weight } from '../../network/robActions_change_weight.ts'
import { robActions_inputneuron } from '../../network/robActions_inputneuron.ts'
import { robActions_outputneuron } from '../../network/robActions_outputneuron.ts'
import { robActions_outputneuron_wo_var } from '../../network/robActions_outputneuron_wo_var.ts'
import { robActions_set_bias } from '../../network/robActions_set_bias.ts'
import { robActions_set_inputneuron_val } from '../../network/robActions_set_inputneuron_val.ts'
import { robActions_set_weight } from '../../network/robActions_set_weight.ts'
import { robSensors_get_bias } from '../../network/robSensors_get_bias.ts'
import { robSensors_get_outputneuron_val } from '../../network/robSensors_get_outputneuron_val.ts'
import { robSensors_get_weight } from '../../network/robSensors_get_weight.ts'
import { robSensors_compass_calibrate } from '../../sensors/robSensors_compass_calibrate.ts'
import { robSensors_getSample } from '../../sensors/robSensors_getSample.ts'
import { robSensors_htcolour_getSample } from '../../sensors/robSensors_htcolour_getSample.ts'
import { robSensors_irseeker_getSample } from '../../sensors/robSensors_irseeker_getSample.ts'
import { robActions_eval_expr } from '../../text/robActions_eval_expr.ts'
import { robActions_eval_stmt } from '../../text/robActions_eval_stmt.ts'
import { robText_append } from '../../text/robText_append.ts'
import { robText_join } from '../../text/robText_join.ts'
import { text_cast_char_toNumber } from '../../text/text_cast_char_toNumber.ts'
import { text_cast_string_toNumber } from '../../text/text_cast_string_toNumber.ts'
import { robGlobalVariables_declare } from '../../variables/robGlobalVariables_declare.ts'
import { robLocalVariables_declare } from '../../variables/robLocalVariables_declare.ts'
import { variables_get } from '../../variables/variables_get.ts'
import { variables_set } from '../../variables/variables_set.ts'
import type { TypeIn } from '../packs.ts'
import type { Definition } from '../../types.ts'

export const blocks: { readonly [T in TypeIn<'expert'>]: Definition } = {
  mbedActions_play_note,
  robActions_assert,
  robActions_brickLight_off,
  robActions_brickLight_on,
  robActions_brickLight_reset,
  robActions_debug,
  robActions_display_picture,
  robActions_display_picture_new,
  robActions_motorDiff_curve,
  robActions_motorDiff_curve_for,
  robActions_motor_getPower,
  robActions_motor_on_for,
  robActions_motor_setPower,
  robActions_motor_stop,
  robActions_play_file,
  robActions_play_getVolume,
  robActions_play_setVolume,
  robActions_sayText,
  robActions_sayText_parameters,
  robActions_setLanguage,
  controls_flow_statements,
  controls_repeat,
  controls_whileUntil,
  robControls_for,
  robControls_forEach,
  robControls_wait,
  robControls_wait_for,
  text_comment,
  robProcedures_callnoreturn,
  robProcedures_callreturn,
  robProcedures_defnoreturn,
  robProcedures_defreturn,
  robProcedures_ifreturn,
  robLists_create_with,
  robLists_getIndex,
  robLists_getSublist,
  robLists_indexOf,
  robLists_isEmpty,
  robLists_length,
  robLists_repeat,
  robLists_setIndex,
  logic_boolean,
  logic_negate,
  logic_null,
  logic_operation,
  logic_ternary,
  math_cast_toChar,
  math_cast_toString,
  math_constant,
  math_constrain,
  math_modulo,
  math_number_property,
  math_on_list,
  math_random_float,
  math_random_int,
  math_round,
  math_single,
  math_trig,
  robMath_change,
  robCommunication_receiveBlock,
  robCommunication_sendBlock,
  robCommunication_startConnection,
  robCommunication_waitForConnection,
  robActions_NNstep,
  robActions_change_bias,
  robActions_change_weight,
  robActions_inputneuron,
  robActions_outputneuron,
  robActions_outputneuron_wo_var,
  robActions_set_bias,
  robActions_set_inputneuron_val,
  robActions_set_weight,
  robSensors_get_bias,
  robSensors_get_outputneuron_val,
  robSensors_get_weight,
  robSensors_compass_calibrate,
  robSensors_getSample,
  robSensors_htcolour_getSample,
  robSensors_irseeker_getSample,
  robActions_eval_expr,
  robActions_eval_stmt,
  robText_append,
  robText_join,
  text_cast_char_toNumber,
  text_cast_string_toNumber,
  robGlobalVariables_declare,
  robLocalVariables_declare,
  variables_get,
  variables_set,
}
