import type { Standpoint } from '@botgarten/lab/why'
import type { RunningLab } from '#lab/running.svelte.ts'

/** Where a lab stands: from here a drive can be imagined. */
export function standpointOf({ document, floor, moment, view }: RunningLab): Standpoint {
  const going = view.phase === 'running' || view.phase === 'paused'
  return { document, floor, moment, going }
}
