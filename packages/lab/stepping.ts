import type { Run } from './run.ts'

/** Ticks after which a step gives up waiting for a block or a net: ten seconds. */
const STEP_LIMIT = 600

/** A lab that is walked through step by step. */
export interface Walk {
  readonly run: Run
  /** May a step look for more? */
  goesOn(): boolean
  tick(): void
}

/** Ids of the blocks at which a run stops before they are executed. */
export type Stops = ReadonlySet<string>

/** Each program's next block, inside this tick. */
function nextBlocks(run: Run, stops: Stops) {
  const begun = run.robots.map(({ thread }) => thread.started)
  const over = run.stepBlocks()
  const moved = run.robots.map(({ thread }, robot) => thread.started !== begun[robot])
  const stopped = run.robots.some(({ thread }, robot) => moved[robot] && stops.has(thread.lit ?? ''))
  return { over, moved, stopped }
}

/** Runs the programs of this tick up to a stop. Returns whether there was one; otherwise their tick is over. */
export function reachStop(run: Run, stops: Stops): boolean {
  for (;;) {
    const { over, stopped } = nextBlocks(run, stops)
    if (stopped || over) return stopped
  }
}

/**
 * Until the robot's next block is lit; with `over` the next one that is not inside the block of now, functions that it calls
 * included. A stop on the way ends the step.
 */
export function stepBlock(walk: Walk, robot: number, over: boolean, stops: Stops): void {
  const thread = () => walk.run.robots[robot]?.thread
  const deepest = over ? (thread()?.frames.length ?? 0) : Infinity
  for (let ticks = 0; ticks < STEP_LIMIT && walk.goesOn();) {
    const { over: tickOver, moved, stopped } = nextBlocks(walk.run, stops)
    if (stopped || (moved[robot] && thread()!.frames.length <= deepest)) return
    if (!tickOver) continue
    walk.tick()
    ticks++
  }
}

/** Until the robot's next run of a net. */
export function stepNetwork(walk: Walk, robot: number): void {
  const runs = walk.run.robots[robot]?.brains.runs
  for (let ticks = 0; ticks < STEP_LIMIT && walk.goesOn(); ticks++) {
    walk.tick()
    if (walk.run.robots[robot]?.brains.runs !== runs) return
  }
}
