import { runLane, type Heat, type Race, type RunRecord } from '@botgarten/experiments/race'

export interface Asked {
  readonly race: Race
  readonly heat: Heat
}
export interface Answered {
  readonly heat: Heat
  readonly records: readonly RunRecord[]
}

self.onmessage = ({ data: { race, heat } }: MessageEvent<Asked>) =>
  self.postMessage({
    heat,
    records: heat.runs.map((run) => runLane(race, heat.lane, run)),
  } satisfies Answered)
