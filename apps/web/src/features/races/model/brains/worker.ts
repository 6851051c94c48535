// Brains race beside the page: each start takes its time.
import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { race, type Ground, type Lane, type LaneResult } from '@botgarten/experiments/brain-race'

export interface Asked {
  readonly ground: Ground
  readonly lane: Lane
  readonly seed: number
}
/** `done`: 0..1 of the lane; `result`: when it is all of it. */
export interface Answered {
  readonly done: number
  readonly result?: LaneResult
}

addBlocks(learning)
addBlocks(expert)

/** Answers between two reports. */
const every = 100

self.onmessage = ({ data: { ground, lane, seed } }: MessageEvent<Asked>) => {
  const { starts, seconds } = ground.course
  const pauses = starts.length * seconds * 10
  const racing = race(ground, [lane], seed)
  for (let at = 0; ; at++) {
    const { done, value } = racing.next()
    if (done) return self.postMessage({ done: 1, result: value[0]! } satisfies Answered)
    if (at % every === 0) self.postMessage({ done: at / pauses } satisfies Answered)
  }
}
