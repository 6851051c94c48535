import type { Block, Context, Definition, Frame, Next } from '../types.ts'
import { done, wait } from './next.ts'

/** Asks for the inputs one after the other, then acts; a block that waits is asked to act again every tick. */
export const afterAsking =
  (
    questions: readonly Next[],
    act: (frame: Frame, context: Context, block: Block) => Next,
  ): Definition['run'] =>
  (block, frame, context) =>
    questions[frame.stage++] ?? act(frame, context, block)

/** Ticks are counted, not seconds compared: 1/60 has no exact binary form. */
const ticksAt = (seconds: number) => Math.round(seconds * 60)
const ticksIn = (milliseconds: number) => Math.max(0, Math.ceil((milliseconds * 60) / 1000 - 1e-9))

/** Waits the fewest whole ticks that are not shorter than the time; the frame's counter holds the tick to wake in. */
export function waiting(frame: Frame, context: Context, milliseconds: number): Next {
  const tick = ticksAt(context.now)
  frame.counter ??= tick + ticksIn(milliseconds)
  return tick >= frame.counter ? done : wait
}

/** Is this the first time the block acts? Frames are data, so that it has to be written there. */
function firstTime(frame: Frame): boolean {
  if (frame.counter !== undefined) return false
  frame.counter = 1
  return true
}

/** Starts a move that ends by itself and stays until it has. */
export function moving(frame: Frame, context: Context, left: number, right: number, degrees: number): Next {
  if (degrees === 0 || (left === 0 && right === 0)) {
    context.robot.move({ left: 0, right: 0 })
    return done
  }
  if (firstTime(frame)) context.robot.move({ left, right, degrees })
  return context.robot.arrived() ? done : wait
}

/** Way of a wheel of this diameter (cm) in degrees of its turning. */
export const wheelDegrees = (cm: number, wheelDiameter: number): number =>
  (Math.abs(cm) / (Math.PI * wheelDiameter)) * 360
