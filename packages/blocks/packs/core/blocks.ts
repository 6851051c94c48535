// Made by `npm run blocks`.

import { actions_bricklight_off_ev3 } from '../../action/actions_bricklight_off_ev3.ts'
import { actions_bricklight_on_ev3 } from '../../action/actions_bricklight_on_ev3.ts'
import { robActions_display_clear } from '../../action/robActions_display_clear.ts'
import { robActions_display_text } from '../../action/robActions_display_text.ts'
import { robActions_motorDiff_on } from '../../action/robActions_motorDiff_on.ts'
import { robActions_motorDiff_on_for } from '../../action/robActions_motorDiff_on_for.ts'
import { robActions_motorDiff_stop } from '../../action/robActions_motorDiff_stop.ts'
import { robActions_motorDiff_turn } from '../../action/robActions_motorDiff_turn.ts'
import { robActions_motorDiff_turn_for } from '../../action/robActions_motorDiff_turn_for.ts'
import { robActions_motor_on } from '../../action/robActions_motor_on.ts'
import { robActions_play_tone } from '../../action/robActions_play_tone.ts'
import { controls_repeat_ext } from '../../control/controls_repeat_ext.ts'
import { robControls_if } from '../../control/robControls_if.ts'
import { robControls_ifElse } from '../../control/robControls_ifElse.ts'
import { robControls_loopForever } from '../../control/robControls_loopForever.ts'
import { robControls_start } from '../../control/robControls_start.ts'
import { robControls_wait_time } from '../../control/robControls_wait_time.ts'
import { logic_compare } from '../../logic/logic_compare.ts'
import { math_arithmetic } from '../../math/math_arithmetic.ts'
import { math_number } from '../../math/math_number.ts'
import { ai_easy_list } from '../../network/ai_easy_list.ts'
import { ai_neural_network } from '../../network/ai_neural_network.ts'
import { ai_nn_input_node_coloursensor_color } from '../../network/ai_nn_input_node_coloursensor_color.ts'
import { ai_nn_input_node_coloursensor_light } from '../../network/ai_nn_input_node_coloursensor_light.ts'
import { ai_nn_input_node_coloursensor_rgb_channel } from '../../network/ai_nn_input_node_coloursensor_rgb_channel.ts'
import { ai_nn_input_node_ultrasonic } from '../../network/ai_nn_input_node_ultrasonic.ts'
import { ai_nn_output_node } from '../../network/ai_nn_output_node.ts'
import { ai_nn_output_node_led } from '../../network/ai_nn_output_node_led.ts'
import { ai_nn_output_node_sound } from '../../network/ai_nn_output_node_sound.ts'
import { ai_nn_output_node_text } from '../../network/ai_nn_output_node_text.ts'
import { robColour_picker } from '../../sensors/robColour_picker.ts'
import { robSensors_colour_getSample } from '../../sensors/robSensors_colour_getSample.ts'
import { robSensors_compass_getSample } from '../../sensors/robSensors_compass_getSample.ts'
import { robSensors_encoder_getSample } from '../../sensors/robSensors_encoder_getSample.ts'
import { robSensors_encoder_reset } from '../../sensors/robSensors_encoder_reset.ts'
import { robSensors_gyro_getSample } from '../../sensors/robSensors_gyro_getSample.ts'
import { robSensors_gyro_reset } from '../../sensors/robSensors_gyro_reset.ts'
import { robSensors_infrared_getSample } from '../../sensors/robSensors_infrared_getSample.ts'
import { robSensors_key_getSample } from '../../sensors/robSensors_key_getSample.ts'
import { robSensors_odometry_getSample } from '../../sensors/robSensors_odometry_getSample.ts'
import { robSensors_sound_getSample } from '../../sensors/robSensors_sound_getSample.ts'
import { robSensors_timer_getSample } from '../../sensors/robSensors_timer_getSample.ts'
import { robSensors_timer_reset } from '../../sensors/robSensors_timer_reset.ts'
import { robSensors_touch_getSample } from '../../sensors/robSensors_touch_getSample.ts'
import { robSensors_ultrasonic_getSample } from '../../sensors/robSensors_ultrasonic_getSample.ts'
import { text } from '../../text/text.ts'
import type { TypeIn } from '../packs.ts'
import type { Definition } from '../../types.ts'

export const blocks: { readonly [T in TypeIn<'core'>]: Definition } = {
  actions_bricklight_off_ev3,
  actions_bricklight_on_ev3,
  robActions_display_clear,
  robActions_display_text,
  robActions_motorDiff_on,
  robActions_motorDiff_on_for,
  robActions_motorDiff_stop,
  robActions_motorDiff_turn,
  robActions_motorDiff_turn_for,
  robActions_motor_on,
  robActions_play_tone,
  controls_repeat_ext,
  robControls_if,
  robControls_ifElse,
  robControls_loopForever,
  robControls_start,
  robControls_wait_time,
  logic_compare,
  math_arithmetic,
  math_number,
  ai_easy_list,
  ai_neural_network,
  ai_nn_input_node_coloursensor_color,
  ai_nn_input_node_coloursensor_light,
  ai_nn_input_node_coloursensor_rgb_channel,
  ai_nn_input_node_ultrasonic,
  ai_nn_output_node,
  ai_nn_output_node_led,
  ai_nn_output_node_sound,
  ai_nn_output_node_text,
  robColour_picker,
  robSensors_colour_getSample,
  robSensors_compass_getSample,
  robSensors_encoder_getSample,
  robSensors_encoder_reset,
  robSensors_gyro_getSample,
  robSensors_gyro_reset,
  robSensors_infrared_getSample,
  robSensors_key_getSample,
  robSensors_odometry_getSample,
  robSensors_sound_getSample,
  robSensors_timer_getSample,
  robSensors_timer_reset,
  robSensors_touch_getSample,
  robSensors_ultrasonic_getSample,
  text,
}
