import type { Context, Frame, Next } from '../types.ts'
import { waiting } from './steps.ts'
import { textOf } from './texts.ts'

/** A plain voice says about fifteen letters a second. */
const msPerLetter = 65
const shortest = 500

/** Says the frame's first value and waits until it is said. `speed`, `pitch`: 0 to 100. */
export function speech(frame: Frame, context: Context, speed: number, pitch: number): Next {
  const text = textOf(frame.got[0])
  const milliseconds = Math.max(shortest, (text.length * msPerLetter * 80) / (50 + speed))
  if (frame.counter === undefined) context.robot.say(text, speed, pitch)
  return waiting(frame, context, milliseconds)
}
