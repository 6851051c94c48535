import type { Context, Frame, Next } from '../types.ts'
import { waiting } from './steps.ts'
import { textOf } from './texts.ts'

/** A plain voice says about fifteen letters a second. */
const msPerLetter = 65
const shortest = 500

/** How long it takes to say a text, in milliseconds. `speed`: 0 to 100. */
export const speechLength = (text: string, speed: number): number =>
  Math.max(shortest, (text.length * msPerLetter * 80) / (50 + speed))

/** Says the frame's first value and waits until it is said. `speed`, `pitch`: 0 to 100. */
export function speech(frame: Frame, context: Context, speed: number, pitch: number): Next {
  const text = textOf(frame.got[0])
  if (frame.counter === undefined) context.robot.say(text, speed, pitch)
  return waiting(frame, context, speechLength(text, speed))
}
