/** An event of Chromium's trace; `dur` in microseconds. */
interface Event {
  readonly name: string
  readonly ph: string
  readonly pid: number
  readonly tid: number
  readonly ts?: number
  readonly dur?: number
  /** Time of the processor alone. */
  readonly tdur?: number
  readonly args?: { readonly name?: string }
}

export interface MainThread {
  /** Milliseconds of the processor for every task, in order: what other programs do meanwhile does not count. */
  readonly tasks: readonly number[]
  /** Frames that the main thread handed on to be drawn. A page runs several pieces of code for one of them. */
  readonly frames: number
}

/** The main thread of the busiest page in a trace. */
export function mainThreadOf(trace: string): MainThread {
  const { traceEvents: events } = JSON.parse(trace) as { traceEvents: Event[] }
  const threads = events.filter(({ name, args }) => name === 'thread_name' && args?.name === 'CrRendererMain')
  const own = threads.map(({ pid, tid }) => events.filter((event) => event.pid === pid && event.tid === tid))
  const found = own.map((mine) => ({
    tasks: mine.filter(isTask).map(({ dur = 0, tdur }) => (tdur ?? dur) / 1000),
    frames: mine.filter(({ name }) => name === 'Commit').length,
  }))
  const [busiest] = found.sort((a, b) => b.frames - a.frames)
  if (busiest === undefined) throw new Error('The trace has no page in it.')
  return busiest
}

const isTask = ({ name, ph }: Event) => name === 'RunTask' && ph === 'X'

/**
 * Milliseconds of the processor for every task in which a page has set this mark: what other programs do meanwhile does not
 * count.
 */
export function tasksWithMark(trace: string, mark: string): readonly number[] {
  const { traceEvents: events } = JSON.parse(trace) as { traceEvents: Event[] }
  const marks = events.filter(({ name }) => name === mark)
  const tasks = events.filter(isTask)
  const holds = (task: Event) =>
    marks.some(
      ({ pid, tid, ts = 0 }) =>
        pid === task.pid && tid === task.tid && ts >= task.ts! && ts <= task.ts! + (task.dur ?? 0),
    )
  return tasks.filter(holds).map(({ tdur, dur = 0 }) => (tdur ?? dur) / 1000)
}
