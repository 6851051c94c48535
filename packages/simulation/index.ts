export type * from './types.ts'
export { degreesOf, radiansOf, samePose } from './angles.ts'
export { rollsOn } from './body/late.ts'
export { encoder, isPressed, pressKey, resetEncoder, resetGyro, resetTimer, timer } from './body/panel.ts'
export {
  isSameMotor,
  isSameMotors,
  motorAt,
  motorPorts,
  withMotor,
  withMotors,
  withWheel,
} from './body/plugged.ts'
export { placeFor, withoutSensor, withSensor } from './body/places.ts'
export {
  arrived,
  clearDisplay,
  display,
  freshRobot,
  motorTurned,
  say,
  setLanguage,
  setLed,
  setMotor,
  setVolume,
  showPicture,
  startMove,
  stopMotors,
  tone,
  turnMotor,
} from './body/verbs.ts'
export { cardConfig, defaultConfig } from './configs.ts'
export { COLOURS, colourOf } from './floor/colours.ts'
export { coloursOn } from './floor/on-floor.ts'
export { paintFloor } from './floor/paint.ts'
export type { Picture } from './floor/picture.ts'
export { FRONT, HALF_WIDTH, REAR } from './geometry/parts.ts'
export { triangleOf } from './geometry/triangle.ts'
export { MODES_OF } from './sensors/readings.ts'
export { createSimulation } from './simulation.ts'
export { KEYFRAME_EVERY, TICKS_PER_SECOND } from './time.ts'
