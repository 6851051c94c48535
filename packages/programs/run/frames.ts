import type { Frame, Value } from '@botgarten/blocks'

/** Frames that were used and may be used again: a net's tick would otherwise make eight of them. */
export type FreeFrames = Frame[]

export function takeFrame(free: FreeFrames, block: string): Frame {
  const frame = free.pop()
  if (!frame) return { block, stage: 0, got: [], counter: undefined, mark: undefined }
  return resetFrame(frame, block)
}

export function resetFrame(frame: Frame, block: string): Frame {
  frame.block = block
  frame.stage = 0
  while (frame.got.length > 0) frame.got.pop()
  frame.counter = undefined
  frame.mark = undefined
  return frame
}

/** `value`: what the block gave; a list may have given the frame's own array, which then is the parent's. */
export function leaveFrame(free: FreeFrames, frame: Frame, value: Value | undefined): void {
  if (value === frame.got) frame.got = []
  free.push(frame)
}
